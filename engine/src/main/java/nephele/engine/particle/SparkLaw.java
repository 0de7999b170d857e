package nephele.engine.particle;

import nephele.engine.level.Emitter;
import nephele.engine.math.Chance;

/**
 * Sparks: thrown up in a cone, under gravity and drag in proportion to speed, which has a closed form. They glow along
 * the path that they cover in a fiftieth of a second, and cool.
 */
record SparkLaw(Emitter emitter, double longest, double speed) implements ParticleLaw {
    private static final double DRAG_PER_SECOND = 0.9;
    private static final double EXPOSED_SECONDS = 1.0 / 50;
    private static final double WIDTH = 0.016;
    private static final double RADIANCE = 11;

    SparkLaw(Emitter emitter) {
        // With drag, 1.25 times the speed that reaches the top without it does.
        this(
                emitter,
                emitter.longestLifeSeconds(),
                1.25 * Math.sqrt(2 * 9.81 * 0.9 * emitter.size().y()));
    }

    @Override
    public boolean at(long index, double age, double clock, ParticleState out) {
        long dice = Chance.dice(emitter.seed(), index);
        double life = longest * (0.45 + 0.55 * Chance.unit(dice, 1));
        if (age >= life) {
            return false;
        }
        double fraction = age / life;
        double start = speed * (0.45 + 0.55 * Chance.unit(dice, 2));
        double turns = Chance.unit(dice, 3);
        double spread = Math.sqrt(Chance.unit(dice, 4));
        double outX = 0.42 * emitter.size().x() / longest * spread * Waves.cosine(turns) * 1.6;
        double outZ = 0.42 * emitter.size().z() / longest * spread * Waves.sine(turns) * 1.6;
        double kept = Math.exp(-DRAG_PER_SECOND * age);
        double path = (1 - kept) / DRAG_PER_SECOND;
        ParticleLaw.fall(start, DRAG_PER_SECOND, age, kept, out);
        double rise = out.y;
        double up = out.alongY;
        out.place(outX * path, rise - 0.48 * emitter.size().y(), outZ * path);
        double half = 0.5 * EXPOSED_SECONDS;
        out.stretch(half * outX * kept, half * up, half * outZ * kept);
        out.halfWidth = ParticleLaw.halfWidth(emitter, WIDTH) * (0.6 + 0.4 * (1 - fraction));
        double heat = 1 - fraction;
        double twinkle = 0.7 + 0.3 * Waves.sine(9 * age + turns);
        out.emission(1, 0.18 + 0.42 * heat, 0.015 + 0.2 * heat * heat, RADIANCE * heat * twinkle);
        out.opacity = 0.2 * heat;
        out.albedo = 0;
        out.picture = ParticlePicture.STREAK.number(index);
        out.turns = 0;
        return true;
    }
}
