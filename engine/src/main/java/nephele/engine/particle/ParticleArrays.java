package nephele.engine.particle;

import java.util.Arrays;

/** The particles of all emitters at one time, an array for each number; places are relative to their emitter's centre. */
public final class ParticleArrays {
    private int count;
    private float[] x;
    private float[] y;
    private float[] z;
    private float[] halfWidth;
    private float[] alongX;
    private float[] alongY;
    private float[] alongZ;
    private float[] opacity;
    private float[] albedo;
    private float[] red;
    private float[] green;
    private float[] blue;
    /** Number of the picture, and as its fraction the rotation in turns. */
    private float[] look;

    private int[] emitter;

    ParticleArrays(int capacity) {
        x = new float[capacity];
        y = new float[capacity];
        z = new float[capacity];
        halfWidth = new float[capacity];
        alongX = new float[capacity];
        alongY = new float[capacity];
        alongZ = new float[capacity];
        opacity = new float[capacity];
        albedo = new float[capacity];
        red = new float[capacity];
        green = new float[capacity];
        blue = new float[capacity];
        look = new float[capacity];
        emitter = new int[capacity];
    }

    void clear() {
        count = 0;
    }

    void add(int ofEmitter, ParticleState state) {
        if (count == x.length) {
            grow();
        }
        int at = count++;
        x[at] = (float) state.x;
        y[at] = (float) state.y;
        z[at] = (float) state.z;
        halfWidth[at] = (float) state.halfWidth;
        alongX[at] = (float) state.alongX;
        alongY[at] = (float) state.alongY;
        alongZ[at] = (float) state.alongZ;
        opacity[at] = (float) state.opacity;
        albedo[at] = (float) state.albedo;
        red[at] = (float) state.red;
        green[at] = (float) state.green;
        blue[at] = (float) state.blue;
        // Below 1, also after rounding to float.
        double turns = Math.min(state.turns - Math.floor(state.turns), 0.9999);
        look[at] = (float) (state.picture + turns);
        emitter[at] = ofEmitter;
    }

    private void grow() {
        int capacity = 2 * x.length + 64;
        x = Arrays.copyOf(x, capacity);
        y = Arrays.copyOf(y, capacity);
        z = Arrays.copyOf(z, capacity);
        halfWidth = Arrays.copyOf(halfWidth, capacity);
        alongX = Arrays.copyOf(alongX, capacity);
        alongY = Arrays.copyOf(alongY, capacity);
        alongZ = Arrays.copyOf(alongZ, capacity);
        opacity = Arrays.copyOf(opacity, capacity);
        albedo = Arrays.copyOf(albedo, capacity);
        red = Arrays.copyOf(red, capacity);
        green = Arrays.copyOf(green, capacity);
        blue = Arrays.copyOf(blue, capacity);
        look = Arrays.copyOf(look, capacity);
        emitter = Arrays.copyOf(emitter, capacity);
    }

    public int count() {
        return count;
    }

    public float x(int particle) {
        return x[particle];
    }

    public float y(int particle) {
        return y[particle];
    }

    public float z(int particle) {
        return z[particle];
    }

    public float halfWidth(int particle) {
        return halfWidth[particle];
    }

    public float alongX(int particle) {
        return alongX[particle];
    }

    public float alongY(int particle) {
        return alongY[particle];
    }

    public float alongZ(int particle) {
        return alongZ[particle];
    }

    public float opacity(int particle) {
        return opacity[particle];
    }

    public float albedo(int particle) {
        return albedo[particle];
    }

    public float red(int particle) {
        return red[particle];
    }

    public float green(int particle) {
        return green[particle];
    }

    public float blue(int particle) {
        return blue[particle];
    }

    /** Returns the {@link ParticlePicture#number}, and as its fraction the rotation in turns. */
    public float look(int particle) {
        return look[particle];
    }

    /** Returns the index of the emitter. */
    public int emitter(int particle) {
        return emitter[particle];
    }
}
