package nephele.engine.particle;

import nephele.engine.level.Emitter;
import nephele.engine.math.Chance;

/** Rain and snow: drops fall straight with their final speed, flakes drift about their path. */
record FallLaw(Emitter emitter, double speed, double halfWidth) implements ParticleLaw {
    /** The time of which a drop shows its path, as in a picture of a film. */
    static final double EXPOSED_SECONDS = 1.0 / 40;

    /** Half the length of a drop's picture. */
    static final double RAIN_HALF_LENGTH = 0.5 * EXPOSED_SECONDS * Emitter.RAIN_METRES_PER_SECOND;

    private static final double RAIN_WIDTH = 0.007;
    private static final double SNOW_WIDTH = 0.035;
    private static final double DRIFT_METRES = 0.22;

    FallLaw(Emitter emitter) {
        this(
                emitter,
                isRain(emitter) ? Emitter.RAIN_METRES_PER_SECOND : Emitter.SNOW_METRES_PER_SECOND,
                ParticleLaw.halfWidth(emitter, isRain(emitter) ? RAIN_WIDTH : SNOW_WIDTH));
    }

    private static boolean isRain(Emitter emitter) {
        return emitter.kind() == Emitter.Kind.RAIN;
    }

    /** Writes the column in which a drop falls. */
    static void column(Emitter emitter, long index, ParticleState out) {
        long dice = Chance.dice(emitter.seed(), index);
        out.place(
                0.5 * emitter.size().x() * Chance.signed(dice, 1),
                0,
                0.5 * emitter.size().z() * Chance.signed(dice, 2));
    }

    /** Writes what a drop of rain looks like, but for its place and its path. */
    static void drop(Emitter emitter, long index, ParticleState out) {
        long dice = Chance.dice(emitter.seed(), index);
        out.emission(0, 0, 0, 0);
        out.albedo = 1;
        out.turns = 0;
        out.halfWidth = ParticleLaw.halfWidth(emitter, RAIN_WIDTH) * (0.7 + 0.6 * Chance.unit(dice, 3));
        out.opacity = 0.27;
        out.picture = ParticlePicture.STREAK.number(index);
    }

    @Override
    public boolean at(long index, double age, double clock, ParticleState out) {
        double fallen = speed * age;
        if (fallen >= emitter.size().y()) {
            return false;
        }
        long dice = Chance.dice(emitter.seed(), index);
        double x = 0.5 * emitter.size().x() * Chance.signed(dice, 1);
        double z = 0.5 * emitter.size().z() * Chance.signed(dice, 2);
        double y = 0.5 * emitter.size().y() - fallen;
        if (isRain(emitter)) {
            drop(emitter, index, out);
            out.place(x, y, z);
            out.stretch(0, 0.5 * EXPOSED_SECONDS * speed, 0);
        } else {
            out.emission(0, 0, 0, 0);
            out.albedo = 1;
            out.turns = 0;
            drift(index, age, clock, out, x, y, z);
        }
        return true;
    }

    private void drift(long index, double age, double clock, ParticleState out, double x, double y, double z) {
        long dice = Chance.dice(emitter.seed(), index);
        double phase = Chance.unit(dice, 3);
        double beat = 0.22 + 0.3 * Chance.unit(dice, 4);
        out.place(
                x + DRIFT_METRES * (Waves.sine(beat * age + phase) + Waves.sine(0.07 * clock + 0.05 * y)),
                y + 0.05 * Waves.sine(2 * beat * age + phase),
                z
                        + DRIFT_METRES
                                * (Waves.cosine(0.8 * beat * age + phase) + Waves.sine(0.05 * clock + 0.06 * y + 0.3)));
        out.halfWidth = halfWidth * (0.6 + 0.7 * Chance.unit(dice, 5));
        out.stretch(0, 0, 0);
        out.opacity = 0.9;
        out.picture = ParticlePicture.SPOT.number(index);
    }
}
