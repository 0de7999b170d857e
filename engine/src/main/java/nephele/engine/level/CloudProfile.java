package nephele.engine.level;

/** The kind of cloud that noise makes: how its density and edges change between base and top. */
public enum CloudProfile {
    /** A sheet: flat above and below, its edges soft. */
    STRATUS,
    /** Heaps with a flat base and rounded tops. */
    CUMULUS,
    /** Towers that reach the top of the extent, where an anvil may spread. */
    CUMULONIMBUS
}
