# The package that find_package(Terrane) and pkg-config find.
