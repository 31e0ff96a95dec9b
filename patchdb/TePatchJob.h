#pragma once

#include "patchdb/TeHeightBuilder.h"
#include "patchdb/TeOwnMaps.h"

/// Makes one base patch in slices: finds or makes its source maps, blends them, and stores the result in
/// the patch's record. Any slicing and any order of jobs gives the same bits. The database and the provider
/// of maps must outlive the job; the record may come and go meanwhile.
class TePatchJob {
public:
  enum class Stage { Waiting, SourceMaps, Blend, Ended };

  /// Makes its maps by itself, or lets a provider make them, which may serve other jobs too.
  TePatchJob(TePatchDatabase& database, const TePatchKey& key, TeMapProvider* provider = nullptr);
  ~TePatchJob();
  TePatchJob(const TePatchJob&) = delete;
  TePatchJob& operator=(const TePatchJob&) = delete;

  /// Does work until the allowance is spent, at least one unit unless it is blocked.
  TeProgress step(TeAllowance& allowance);
  TeProgress finish();
  TeProgress progress() const { return m_progress; }
  Stage stage() const;
  /// True if all maps that it lacks are being made elsewhere, so that step() would do nothing.
  bool blocked() const;
  /// From now on it waits for nobody: blocked() is false.
  void hurry() { m_hurries = true; }
  const TePatchKey& key() const { return m_key; }
  /// Why it failed, be it for want of memory; only after Failed.
  const TeError& error() const { return m_error; }

  /// Finds or makes the maps; Done when all are there.
  TeProgress makeMaps(TeAllowance& allowance);
  const TePatchMaps& maps() const { return m_maps; }

private:
  TeStatus requestMaps();
  void releaseMap(int corner);
  void releaseMaps();
  TeProgress provideMaps(TeAllowance& allowance);
  TeProgress makeHeights(TeAllowance& allowance);
  TeProgress failWithoutMemory();
  TeProgress fail(const TeError& error);

  TePatchDatabase* m_database;
  TePatchKey m_key;
  TeOwnMaps m_ownMaps;
  TeMapProvider* m_provider;
  bool m_hurries = false;
  TeProgress m_progress = TeProgress::Working;
  TeError m_error;
  std::optional<TeNeededMaps> m_needed;
  std::array<bool, 4> m_requested{};
  TePatchMaps m_maps;
  std::unique_ptr<TeHeightBuilder> m_builder;
};
