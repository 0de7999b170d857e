package nephele.engine.particle;

import nephele.engine.level.Emitter;
import nephele.engine.math.Chance;

/**
 * Flames: tongues that rise faster and faster from an elliptical base and draw together. Those of the middle live
 * longest, which gives the fire its point. They add light and hardly cover; hot at the base, they cool on the way.
 */
record FireLaw(Emitter emitter, double breadth, double longest) implements ParticleLaw {
    private static final double RADIANCE = 1.9;
    private static final double SOOT = 0.16;

    FireLaw(Emitter emitter) {
        this(emitter, ParticleLaw.breadth(emitter), emitter.longestLifeSeconds());
    }

    @Override
    public boolean at(long index, double age, double clock, ParticleState out) {
        long dice = Chance.dice(emitter.seed(), index);
        double radius = Math.sqrt(Chance.unit(dice, 1));
        double life = longest * (1 - 0.62 * radius) * (0.72 + 0.28 * Chance.unit(dice, 2));
        if (age >= life) {
            return false;
        }
        double fraction = age / life;
        double risen = age / longest;
        double height = emitter.size().y() * risen * (0.62 + 0.38 * risen);
        double turns = Chance.unit(dice, 3);
        double inward = 0.40 * radius * (1 - 0.72 * fraction);
        double waver = Chance.unit(dice, 4);
        double lean = breadth
                * risen
                * (0.16 * Waves.sine(0.83 * clock - 0.42 * height / breadth)
                        + 0.09 * Waves.sine(2.3 * clock - 1.1 * height / breadth + 0.3 * waver));
        double across = breadth
                * risen
                * (0.15 * Waves.sine(0.71 * clock - 0.5 * height / breadth + 0.4)
                        + 0.08 * Waves.sine(1.9 * clock - 1.3 * height / breadth + 0.3 * waver));
        out.place(
                emitter.size().x() * inward * Waves.cosine(turns) + lean,
                height - 0.46 * emitter.size().y(),
                emitter.size().z() * inward * Waves.sine(turns) + across);
        double half = ParticleLaw.halfWidth(emitter, breadth * (0.34 + 0.20 * Chance.unit(dice, 5)));
        out.halfWidth = half * (0.55 + 0.75 * Math.sqrt(fraction)) * Math.pow(1 - fraction, 0.55);
        double stretch = out.halfWidth * (0.55 + 0.9 * risen);
        out.stretch(
                stretch * 0.5 * Waves.sine(1.1 * clock + waver),
                stretch,
                stretch * 0.5 * Waves.cosine(0.9 * clock + waver));
        double flicker = 0.85 + 0.15 * Waves.sine(5.3 * clock + waver);
        double visible = Waves.step(0, 0.14, fraction) * (1 - Waves.step(0.35, 1, fraction));
        double heat = 1 - fraction;
        out.emission(1, 0.13 + 0.30 * heat * heat, 0.008 + 0.11 * heat * heat * heat, RADIANCE * visible * flicker);
        out.opacity = SOOT * visible;
        out.albedo = 0;
        out.picture = ParticlePicture.TONGUE.number(index);
        out.turns = waver;
        return true;
    }
}
