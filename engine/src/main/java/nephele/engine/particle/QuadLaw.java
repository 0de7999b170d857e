package nephele.engine.particle;

import java.util.Arrays;
import nephele.engine.level.Emitter;
import nephele.engine.math.Chance;

/**
 * The report's particles. In each of 60 frames a second a place's life falls by its part of 0.005 to 0.015; below 0.05
 * the next particle takes the place. A particle is white, with the picture of a cloud; it moves by 1/250 of its speed, 1 to 9, which is then multiplied by 0.99;
 * opacity is the life. Between whole frames the same formulas hold for the fraction. A box of 7.2 m has the report's
 * scale: what is fastest approaches 3.6 m.
 */
final class QuadLaw implements ParticleLaw {
    static final double FRAMES_PER_SECOND = 60;
    static final double KEPT_SPEED = 0.99;
    static final double LEAST_LIFE = 0.05;
    private static final double LOG_KEPT = Math.log(KEPT_SPEED);
    private static final double WIDTH = 0.4;
    private static final int LIFE_NUMBERS = 3;

    private final Emitter emitter;
    private final double halfWidth;
    private final double[] falls;
    private final double[] frames;
    /** The part of its first life after which a place is taken first. */
    private final double[] delays;

    /** The life of each place that {@link #begun} is of; only spares computing it anew. */
    private final long[] lives;

    private final double[] begun;

    QuadLaw(Emitter emitter) {
        this.emitter = emitter;
        halfWidth = ParticleLaw.halfWidth(emitter, WIDTH);
        int places = (int) emitter.mostAtOnce();
        falls = new double[places];
        frames = new double[places];
        delays = new double[places];
        lives = new long[places];
        begun = new double[LIFE_NUMBERS * places];
        Arrays.fill(lives, -1);
        for (int place = 0; place < places; place++) {
            long dice = Chance.dice(emitter.seed(), place);
            falls[place] = 0.005 + 0.01 * Chance.unit(dice, 20);
            frames[place] = Math.floor((1 - LEAST_LIFE) / falls[place]) + 1;
            delays[place] = Chance.unit(dice, 21);
        }
    }

    /** Returns by how much the life of a place falls in a frame. */
    double fall(int place) {
        return falls[place];
    }

    /** Returns the frames of a life at a place: whole, 64 to 191. */
    double frames(int place) {
        return frames[place];
    }

    /** Writes a particle of a place in one of its lives; {@code age} in seconds, less than {@link #frames}. */
    void at(int place, long life, double age, ParticleState out) {
        if (lives[place] != life) {
            begin(place, life);
        }
        double frame = age * FRAMES_PER_SECOND;
        double flown = 1 - Math.exp(LOG_KEPT * frame);
        int at = LIFE_NUMBERS * place;
        out.place(flown * begun[at], flown * begun[at + 1], flown * begun[at + 2]);
        out.halfWidth = halfWidth;
        out.stretch(0, 0, 0);
        out.opacity = Math.max(0, 1 - falls[place] * frame);
        out.emission(1, 1, 1, out.opacity);
        out.albedo = 0;
        out.picture = ParticlePicture.CLOUD.first();
        out.turns = 0;
    }

    /** Finds what stays the same during a life: how far it would fly along each axis. */
    private void begin(int place, long life) {
        long dice = Chance.dice(emitter.seed() + 31L * place, life);
        double up = Chance.signed(dice, 1);
        double level = Math.sqrt(Math.max(0, 1 - up * up));
        double turns = Chance.unit(dice, 2);
        double reach = (1 + 8 * Chance.unit(dice, 3)) / 18;
        int at = LIFE_NUMBERS * place;
        begun[at] = emitter.size().x() * reach * level * Waves.cosine(turns);
        begun[at + 1] = emitter.size().y() * reach * up;
        begun[at + 2] = emitter.size().z() * reach * level * Waves.sine(turns);
        lives[place] = life;
    }

    /** {@code index} is a place; the clock tells which of its lives it has. */
    @Override
    public boolean at(long index, double age, double clock, ParticleState out) {
        int place = (int) index;
        double period = frames[place] / FRAMES_PER_SECOND;
        double since = clock / period - delays[place];
        if (since < 0) {
            return false;
        }
        double life = Math.floor(since);
        at(place, (long) life, (since - life) * period, out);
        return true;
    }
}
