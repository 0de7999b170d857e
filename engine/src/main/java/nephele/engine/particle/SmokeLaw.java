package nephele.engine.particle;

import nephele.engine.level.Emitter;
import nephele.engine.math.Chance;

/** Smoke: billows that rise with a speed that drag brings to a limit, grow, turn, sway together and thin out. */
record SmokeLaw(Emitter emitter, double breadth, double longest) implements ParticleLaw {
    private static final double ALBEDO = 0.86;

    SmokeLaw(Emitter emitter) {
        this(emitter, ParticleLaw.breadth(emitter), emitter.longestLifeSeconds());
    }

    @Override
    public boolean at(long index, double age, double clock, ParticleState out) {
        long dice = Chance.dice(emitter.seed(), index);
        double life = longest * (0.7 + 0.3 * Chance.unit(dice, 1));
        if (age >= life) {
            return false;
        }
        double fraction = age / life;
        double risen = age / longest;
        // Velocity decays exponentially to the speed of rising: v = w + (v0 − w) exp(−k t), with v0 = 2.2 w and k T =
        // 3.
        double climbed = risen + 0.4 * (1 - Math.exp(-3 * risen));
        double height = 0.78 * emitter.size().y() * climbed / 1.38;
        double radius = 0.18 * Math.sqrt(Chance.unit(dice, 2)) + 0.20 * risen * Chance.unit(dice, 3);
        double turns = Chance.unit(dice, 4);
        double waver = Chance.unit(dice, 5);
        double lag = height / emitter.size().y();
        double sway = 0.42 * breadth * risen;
        out.place(
                emitter.size().x() * radius * Waves.cosine(turns)
                        + sway
                                * (Waves.sine(0.13 * clock - 0.9 * lag)
                                        + 0.45 * Waves.sine(0.31 * clock - 1.7 * lag + waver)),
                height - 0.46 * emitter.size().y(),
                emitter.size().z() * radius * Waves.sine(turns)
                        + sway
                                * (Waves.sine(0.11 * clock - 0.8 * lag + 0.3)
                                        + 0.45 * Waves.sine(0.27 * clock - 1.5 * lag + waver)));
        double half = ParticleLaw.halfWidth(emitter, breadth * (0.42 + 0.16 * Chance.unit(dice, 6)));
        out.halfWidth = half * (0.7 + 2.5 * Math.pow(fraction, 0.75));
        out.stretch(0, 0, 0);
        out.emission(0, 0, 0, 0);
        double left = 1 - fraction;
        out.opacity = 0.62 * Waves.step(0, 0.12, fraction) * left * Math.sqrt(left);
        out.albedo = ALBEDO;
        out.picture = ParticlePicture.BILLOW.number(index);
        out.turns = waver + 0.03 * age * Chance.signed(dice, 7);
        return true;
    }
}
