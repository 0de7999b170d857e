package nephele.engine.particle;

import java.util.Arrays;

/**
 * The particles of all emitters at one time, in one array: those drawn one after the other are far apart in it, so the
 * numbers of each lie together. Places are relative to the particle's emitter.
 */
public final class ParticleArrays {
    /** Numbers of a particle in {@link #numbers}. */
    public static final int STRIDE = 14;

    // Places of the numbers of a particle.
    public static final int X = 0;
    public static final int Y = 1;
    public static final int Z = 2;
    public static final int HALF_WIDTH = 3;
    public static final int RED = 4;
    public static final int GREEN = 5;
    public static final int BLUE = 6;
    public static final int OPACITY = 7;
    public static final int ALONG_X = 8;
    public static final int ALONG_Y = 9;
    public static final int ALONG_Z = 10;
    /** The {@link ParticlePicture#number}, and as its fraction the rotation in turns. */
    public static final int LOOK = 11;

    public static final int ALBEDO = 12;
    /** The index of the emitter. */
    public static final int EMITTER = 13;

    private int count;
    private float[] numbers;

    ParticleArrays(int capacity) {
        numbers = new float[STRIDE * capacity];
    }

    void clear() {
        count = 0;
    }

    void add(int emitter, ParticleState state) {
        int at = STRIDE * count++;
        if (at == numbers.length) {
            numbers = Arrays.copyOf(numbers, 2 * at + 64 * STRIDE);
        }
        float[] n = numbers;
        n[at + X] = (float) state.x;
        n[at + Y] = (float) state.y;
        n[at + Z] = (float) state.z;
        n[at + HALF_WIDTH] = (float) state.halfWidth;
        n[at + RED] = (float) state.red;
        n[at + GREEN] = (float) state.green;
        n[at + BLUE] = (float) state.blue;
        n[at + OPACITY] = (float) state.opacity;
        n[at + ALONG_X] = (float) state.alongX;
        n[at + ALONG_Y] = (float) state.alongY;
        n[at + ALONG_Z] = (float) state.alongZ;
        // Below 1, also after rounding to float.
        n[at + LOOK] = (float) (state.picture + Math.min(state.turns - Math.floor(state.turns), 0.9999));
        n[at + ALBEDO] = (float) state.albedo;
        n[at + EMITTER] = emitter;
    }

    public int count() {
        return count;
    }

    /** Returns the array: valid until the next evaluation, only to be read, {@link #STRIDE} numbers for each particle. */
    public float[] numbers() {
        return numbers;
    }

    /** Returns one number of a particle. */
    public float get(int particle, int number) {
        return numbers[STRIDE * particle + number];
    }
}
