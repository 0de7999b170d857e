package nephele.engine.particle;

import nephele.engine.level.Emitter;

/** The state of a kind's particles as a function of index and age; the box of the emitter scales it. */
sealed interface ParticleLaw permits FireLaw, SmokeLaw, FallLaw, SparkLaw, ExplosionLaw, QuadLaw {
    /** Metres per second squared. */
    double GRAVITY = 9.81;

    /**
     * Writes the state of a particle.
     *
     * @param index of the particle among all that the emitter makes
     * @param age seconds since its birth, from 0 to the longest life
     * @param clock seconds since the emitter's start; for motions that neighbours share
     * @return false if the particle has ended
     */
    boolean at(long index, double age, double clock, ParticleState out);

    static ParticleLaw of(Emitter emitter) {
        return switch (emitter.kind()) {
            case FIRE -> new FireLaw(emitter);
            case SMOKE -> new SmokeLaw(emitter);
            case RAIN, SNOW -> new FallLaw(emitter);
            case SPARKS -> new SparkLaw(emitter);
            case EXPLOSION -> new ExplosionLaw(emitter);
            case QUADS -> new QuadLaw(emitter);
        };
    }

    /** Returns half the width of particles, or the author's. */
    static double halfWidth(Emitter emitter, double usualWidth) {
        return 0.5 * (emitter.widthMetres() > 0 ? emitter.widthMetres() : usualWidth);
    }

    /** Returns the edge of the square with the area of the emitter's base. */
    static double breadth(Emitter emitter) {
        return Math.sqrt(emitter.size().x() * emitter.size().z());
    }

    /**
     * Writes height and vertical speed under gravity and a drag in proportion to speed, v' = −k v − g, to {@code y} and
     * {@code alongY}.
     *
     * @param speed at the start, upwards
     * @param drag k, per second
     * @param kept exp(−k t)
     */
    static void fall(double speed, double drag, double seconds, double kept, ParticleState out) {
        double limit = GRAVITY / drag;
        out.y = (speed + limit) * (1 - kept) / drag - limit * seconds;
        out.alongY = (speed + limit) * kept - limit;
    }
}
