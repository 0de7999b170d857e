package nephele.engine.particle;

import nephele.engine.level.Emitter;

/**
 * The report's particles. In each of 60 frames a second a place's life falls by its share of 0.005 to 0.015; below 0.05
 * the next particle takes the place. A particle moves by 1/250 of its speed, 1 to 9, which is then multiplied by 0.99;
 * opacity is the life. Between whole frames the same formulas hold for the fraction. A box of 7.2 m has the report's
 * scale: what is fastest approaches 3.6 m.
 */
record QuadLaw(Emitter emitter, double halfWidth) implements ParticleLaw {
    static final double FRAMES_PER_SECOND = 60;
    static final double KEPT_SPEED = 0.99;
    static final double LEAST_LIFE = 0.05;
    private static final double WIDTH = 0.4;
    /** The farthest that a particle of speed 9 can fly: 9 / 250 · (1 + 0.99 + 0.99² + …). */
    private static final double REACH_METRES = 9.0 / 250 / (1 - KEPT_SPEED);

    QuadLaw(Emitter emitter) {
        this(emitter, ParticleLaw.halfWidth(emitter, WIDTH));
    }

    /** Returns by how much the life of a place falls in a frame. */
    double fall(long place) {
        return 0.005 + 0.01 * Chance.unit(emitter.seed(), place, 20);
    }

    /** Returns the frames of a life at a place: whole, 64 to 191. */
    double frames(long place) {
        return Math.floor((1 - LEAST_LIFE) / fall(place)) + 1;
    }

    /** Writes a particle of a place in one of its lives; {@code age} in seconds, less than {@link #frames}. */
    void at(long place, long life, double age, ParticleState out) {
        double frame = age * FRAMES_PER_SECOND;
        long seed = emitter.seed() + 31 * place;
        double up = Chance.signed(seed, life, 1);
        double level = Math.sqrt(Math.max(0, 1 - up * up));
        double turns = Chance.unit(seed, life, 2);
        double speed = 1 + 8 * Chance.unit(seed, life, 3);
        double way = speed / 250 * (1 - Math.pow(KEPT_SPEED, frame)) / (1 - KEPT_SPEED);
        double scale = way / (2 * REACH_METRES);
        out.place(
                emitter.size().x() * scale * level * Waves.cosine(turns),
                emitter.size().y() * scale * up,
                emitter.size().z() * scale * level * Waves.sine(turns));
        out.halfWidth = halfWidth;
        out.stretch(0, 0, 0);
        out.opacity = Math.max(0, 1 - fall(place) * frame);
        double hue = Chance.unit(seed, life, 4);
        out.emission(
                0.5 + 0.5 * Waves.cosine(hue),
                0.5 + 0.5 * Waves.cosine(hue - 1.0 / 3),
                0.5 + 0.5 * Waves.cosine(hue + 1.0 / 3),
                out.opacity);
        out.albedo = 0;
        out.picture = ParticlePicture.SPOT.first();
        out.turns = 0;
    }

    /** {@code index} is a place; the clock tells which of its lives it has. */
    @Override
    public boolean at(long index, double age, double clock, ParticleState out) {
        double period = frames(index) / FRAMES_PER_SECOND;
        double since = clock / period - Chance.unit(emitter.seed(), index, 21);
        if (since < 0) {
            return false;
        }
        double life = Math.floor(since);
        at(index, (long) life, (since - life) * period, out);
        return true;
    }
}
