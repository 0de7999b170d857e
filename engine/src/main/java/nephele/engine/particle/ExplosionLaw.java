package nephele.engine.particle;

import nephele.engine.level.Emitter;
import nephele.engine.math.Chance;

/**
 * An explosion: two thirds of the particles are billows that drag stops within the box, glow, darken to smoke and rise;
 * the others are glowing pieces that fly further and fall.
 */
record ExplosionLaw(Emitter emitter, double breadth, double longest) implements ParticleLaw {
    /** Longest life of the flying pieces, as a fraction of that of the billows. */
    static final double PIECES_LIFE = 0.35;

    private static final double DRAG_PER_SECOND = 5;
    private static final double PIECE_DRAG_PER_SECOND = 1.1;
    private static final double EXPOSED_SECONDS = 1.0 / 45;
    private static final double RADIANCE = 30;
    private static final double BILLOWS = 0.66;
    private static final int LOBES = 13;

    ExplosionLaw(Emitter emitter) {
        this(emitter, ParticleLaw.breadth(emitter), emitter.longestLifeSeconds());
    }

    @Override
    public boolean at(long index, double age, double clock, ParticleState out) {
        long dice = Chance.dice(emitter.seed(), index);
        double turns = Chance.unit(dice, 1);
        double up = Chance.signed(dice, 2);
        double level = Math.sqrt(Math.max(0, 1 - up * up));
        double x = level * Waves.cosine(turns);
        double z = level * Waves.sine(turns);
        if (Chance.unit(dice, 3) > BILLOWS) {
            return piece(index, age, x, up, z, out);
        }
        // Billows gather in lobes, as a fireball is no sphere.
        long lobe = Chance.dice(emitter.seed(), index % LOBES);
        double lobeTurns = Chance.unit(lobe, 10);
        double lobeUp = 0.15 + 0.85 * Chance.signed(lobe, 11);
        double lobeLevel = Math.sqrt(Math.max(0, 1 - lobeUp * lobeUp));
        return billow(
                index,
                age,
                0.55 * x + 0.8 * lobeLevel * Waves.cosine(lobeTurns),
                0.55 * up + 0.8 * lobeUp,
                0.55 * z + 0.8 * lobeLevel * Waves.sine(lobeTurns),
                out);
    }

    private boolean billow(long index, double age, double x, double y, double z, ParticleState out) {
        long dice = Chance.dice(emitter.seed(), index);
        double life = longest * (0.55 + 0.45 * Chance.unit(dice, 4));
        if (age >= life) {
            return false;
        }
        double fraction = age / life;
        double reach = 0.34 * Math.cbrt(Chance.unit(dice, 5)) * (1 - Math.exp(-DRAG_PER_SECOND * age));
        double rise = 0.16 * emitter.size().y() * (fraction + 0.25 * fraction * fraction);
        out.place(
                emitter.size().x() * reach * x,
                emitter.size().y() * reach * (0.75 * y + 0.1) + rise,
                emitter.size().z() * reach * z);
        double half = ParticleLaw.halfWidth(emitter, breadth * (0.15 + 0.13 * Chance.unit(dice, 6)));
        out.halfWidth = half * (0.5 + 1.2 * (1 - Math.exp(-4 * age)) + 0.6 * fraction);
        out.stretch(0, 0, 0);
        double heat = Math.exp(-age * (1.4 + 5.5 * Chance.unit(dice, 7)));
        double left = 1 - fraction;
        out.emission(
                1, 0.09 + 0.50 * heat * heat, 0.006 + 0.28 * heat * heat * heat, RADIANCE * heat * heat * heat * heat);
        out.opacity = 0.9 * Waves.step(0, 0.01, fraction) * left * left;
        out.albedo = 0.22 + 0.2 * fraction;
        out.picture = ParticlePicture.BILLOW.number(index);
        out.turns = Chance.unit(dice, 8) + 0.05 * age * Chance.signed(dice, 9);
        return true;
    }

    private boolean piece(long index, double age, double x, double y, double z, ParticleState out) {
        long dice = Chance.dice(emitter.seed(), index);
        double life = PIECES_LIFE * longest * (0.4 + 0.6 * Chance.unit(dice, 4));
        if (age >= life) {
            return false;
        }
        double heat = 1 - age / life;
        double start = (1.0 + 1.6 * Chance.unit(dice, 5)) / 2;
        double kept = Math.exp(-PIECE_DRAG_PER_SECOND * age);
        double path = start * (1 - kept) / PIECE_DRAG_PER_SECOND;
        ParticleLaw.fall(start * emitter.size().y() * Math.abs(y), PIECE_DRAG_PER_SECOND, age, kept, out);
        double height = out.y;
        double climbing = out.alongY;
        out.place(emitter.size().x() * path * x, height, emitter.size().z() * path * z);
        double half = 0.5 * EXPOSED_SECONDS;
        out.stretch(
                half * start * kept * emitter.size().x() * x,
                half * climbing,
                half * start * kept * emitter.size().z() * z);
        out.halfWidth = 0.012 + 0.002 * breadth;
        out.emission(1, 0.2 + 0.5 * heat, 0.02 + 0.3 * heat * heat, 16 * heat);
        out.opacity = 0.3 * heat;
        out.albedo = 0;
        out.picture = ParticlePicture.STREAK.number(index);
        out.turns = 0;
        return true;
    }
}
