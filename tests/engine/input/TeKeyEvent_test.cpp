#include "engine/input/TeKeyEvent.h"

#include <Inventor/SoDB.h>

#include <gtest/gtest.h>

TEST(TeKeyEvent, HasWhatTheWindowsEventHas) {
  SoDB::init();
  SoKeyboardEvent event;
  event.setKey(SoKeyboardEvent::PAGE_UP);
  event.setState(SoButtonEvent::DOWN);
  EXPECT_EQ(TeKeyEvent::of(event), (TeKeyEvent{SoKeyboardEvent::PAGE_UP, true, false, false, false}));
  event.setState(SoButtonEvent::UP);
  event.setShiftDown(TRUE);
  EXPECT_EQ(TeKeyEvent::of(event), (TeKeyEvent{SoKeyboardEvent::PAGE_UP, false, true, false, false}));
  event.setShiftDown(FALSE);
  event.setCtrlDown(TRUE);
  EXPECT_EQ(TeKeyEvent::of(event), (TeKeyEvent{SoKeyboardEvent::PAGE_UP, false, false, true, false}));
  event.setCtrlDown(FALSE);
  event.setAltDown(TRUE);
  EXPECT_EQ(TeKeyEvent::of(event), (TeKeyEvent{SoKeyboardEvent::PAGE_UP, false, false, false, true}));
}
