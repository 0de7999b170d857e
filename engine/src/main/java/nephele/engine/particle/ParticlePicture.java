package nephele.engine.particle;

/** The shape of a particle in its square. */
public enum ParticlePicture {
    /** Bright in the middle, by a formula. */
    SPOT(0, 1),
    /** Constant along the stretched side, soft across. */
    STREAK(1, 1),
    /** A billow of smoke. */
    BILLOW(2, 4),
    /** A tongue of flame. */
    TONGUE(6, 4),
    /** A small cloud, without relief. */
    CLOUD(10, 1);

    private final int first;
    private final int variants;

    ParticlePicture(int first, int variants) {
        this.first = first;
        this.variants = variants;
    }

    /** Returns the number of its first variant among all pictures. */
    public int first() {
        return first;
    }

    public int variants() {
        return variants;
    }

    /** Returns the number of a variant, modulo their number. */
    public int number(long variant) {
        return first + (int) Math.floorMod(variant, (long) variants);
    }
}
