package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

/** The positions of the samples in a pixel of a multisampled target. */
public final class SamplePositions {
    /** The greatest number of positions. */
    public static final int MOST = 8;

    private SamplePositions() {}

    /**
     * Returns x and y of each sample, pixels from the pixel's centre; the centre for one sample, or if this OpenGL cannot
     * draw into such a target.
     */
    public static float[] of(GlContext gl, int samples) {
        float[] positions = new float[2 * MOST];
        RenderTarget target = samples <= 1 ? null : RenderTarget.multisampled(gl, PixelFormat.RGBA8, 1, 1, samples);
        if (target != null) {
            target.bind();
            int known = Math.min(glGetInteger(GL_SAMPLES), MOST);
            float[] position = new float[2];
            for (int i = 0; i < known; i++) {
                glGetMultisamplefv(GL_SAMPLE_POSITION, i, position);
                positions[2 * i] = position[0] - 0.5f;
                positions[2 * i + 1] = position[1] - 0.5f;
            }
            target.close();
        }
        return positions;
    }
}
