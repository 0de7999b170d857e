package nephele.scenes.fixed;

import java.nio.IntBuffer;
import java.util.Arrays;
import nephele.engine.math.Frustum;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.scenes.fixed.ModelOrder.Run;
import org.lwjgl.BufferUtils;

/** The numbers of the models that a frame submits, run by run; uploaded when they have changed. */
final class VisibleModels implements AutoCloseable {
    private final BufferTexture texels;
    private final IntBuffer staging;
    private final int[] numbers;
    private final int[] uploaded;
    private final int[] starts;
    private int uploadedSize = -1;
    private int size;
    private int runs;

    VisibleModels(GlContext gl, int models) {
        texels = BufferTexture.changingIntegers(gl, "visible models");
        staging = BufferUtils.createIntBuffer(models);
        numbers = new int[models];
        uploaded = new int[models];
        // Every run has at least one model.
        starts = new int[models + 1];
    }

    void restart() {
        size = 0;
        runs = 0;
    }

    void add(Run run, ModelPoses places, Frustum frustum) {
        for (int number = run.first(); number < run.end(); number++) {
            if (places.maySee(number, frustum)) {
                numbers[size++] = number;
            }
        }
        starts[++runs] = size;
    }

    int first(int run) {
        return starts[run];
    }

    int count(int run) {
        return starts[run + 1] - starts[run];
    }

    void bind() {
        if (size != uploadedSize || !Arrays.equals(numbers, 0, size, uploaded, 0, size)) {
            texels.upload(staging.clear().put(numbers, 0, size).flip());
            System.arraycopy(numbers, 0, uploaded, 0, size);
            uploadedSize = size;
        }
        texels.bind(TextureUnit.SCENE_VISIBLE);
    }

    @Override
    public void close() {
        texels.close();
    }
}
