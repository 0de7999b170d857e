package nephele.engine.cloud.field;

/** Upper bounds of the extinction in the cells of a lattice. */
@FunctionalInterface
interface CellBound {
    /**
     * Returns an upper bound, at least 0, of the extinction per metre in a cell. Rounding can ask for a cell beside the
     * first or last one, which then stands for it.
     */
    double perMetre(long i, long j, long k);
}
