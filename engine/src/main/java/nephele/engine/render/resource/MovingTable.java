package nephele.engine.render.resource;

import java.nio.FloatBuffer;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.DoubleFunction;
import java.util.function.DoubleUnaryOperator;
import nephele.engine.render.gl.Texture;
import org.lwjgl.system.MemoryUtil;

/**
 * Layers of a texture that follow a light of the sky. While the light moves they are mixed of two tables, for an
 * elevation that it has had and for one that it will have; the next one is computed beside the frames, so the picture
 * neither lags nor waits.
 */
public final class MovingTable {
    /** A light that has moved farther than to the next table has been moved by something else than time. */
    private static final double CUT_SINE = 0.1;

    private static final double READY_SINE = 0.004;
    private static final double LEAST_SECONDS = 0.25;
    /** The next table is for a later time than its computation is expected to end. */
    private static final double MARGIN = 1.5;

    private final Texture texture;
    private final int firstLayer;
    private final int layers;
    private final Executor threads;
    private final DoubleFunction<float[]> make;
    private Known before;
    private Known after;
    private CompletableFuture<Known> coming;
    private CompletableFuture<Known> first;
    private double stepSeconds = LEAST_SECONDS;
    private float uploadedWeight = Float.NaN;

    private record Known(double sine, float[] texels, double seconds) {}

    /**
     * @param make computes the RGBA texels of all layers from the sine of the light's elevation
     */
    public MovingTable(Texture texture, int firstLayer, int layers, Executor threads, DoubleFunction<float[]> make) {
        this.texture = texture;
        this.firstLayer = firstLayer;
        this.layers = layers;
        this.threads = threads;
        this.make = make;
    }

    /**
     * Returns true if no new table has to be waited for.
     *
     * @param isMoving if the light moves; a table of about its elevation then suffices
     */
    public boolean isReady(double sine, boolean isMoving) {
        if (first != null && first.isDone()) {
            after = first.join();
            before = after;
            coming = null;
            first = null;
            uploadedWeight = Float.NaN;
            upload(1);
        }
        return after != null && (isMoving ? !isBeyond(sine, READY_SINE) : before == after && after.sine == sine);
    }

    /** Computes a table beside the frames; {@link #isReady} says when it is there. */
    public void prepare(double sine) {
        boolean isKnown = after != null && after.sine == sine;
        if (first == null && !isKnown) {
            first = CompletableFuture.supplyAsync(() -> known(sine), threads);
        }
    }

    /** Shows the table of a light that stands still; a new one is waited for. */
    public void show(double sine) {
        if (after == null || before != after || after.sine != sine) {
            coming = null;
            after = known(sine);
            before = after;
            uploadedWeight = Float.NaN;
            upload(1);
        }
    }

    /**
     * Follows a light that moves.
     *
     * @param sineAfter the sine of its elevation after a simulated time in seconds
     */
    public void follow(double sine, DoubleUnaryOperator sineAfter) {
        if (after == null || isBeyond(sine, CUT_SINE)) {
            show(sine);
        }
        double weight = weight(sine);
        if (coming != null && weight >= 1 && coming.isDone()) {
            before = after;
            after = coming.join();
            coming = null;
            stepSeconds = Math.max(LEAST_SECONDS, MARGIN * after.seconds);
            uploadedWeight = Float.NaN;
            weight = weight(sine);
        }
        if (coming == null) {
            double next = sineAfter.applyAsDouble(weight < 1 ? 2 * stepSeconds : stepSeconds);
            coming = next == after.sine ? null : CompletableFuture.supplyAsync(() -> known(next), threads);
        }
        upload((float) weight);
    }

    private Known known(double sine) {
        long start = System.nanoTime();
        float[] texels = make.apply(sine);
        return new Known(sine, texels, (System.nanoTime() - start) * 1e-9);
    }

    private boolean isBeyond(double sine, double margin) {
        return sine < Math.min(before.sine, after.sine) - margin || sine > Math.max(before.sine, after.sine) + margin;
    }

    /** Returns how far the light has come from one table to the other, 0–1. */
    private double weight(double sine) {
        double range = after.sine - before.sine;
        return range == 0 ? 1 : Math.max(0, Math.min(1, (sine - before.sine) / range));
    }

    private void upload(float weight) {
        if (weight == uploadedWeight) {
            return;
        }
        uploadedWeight = weight;
        int count = after.texels.length / layers;
        var bytes = MemoryUtil.memAlloc(Float.BYTES * count);
        for (int layer = 0; layer < layers; layer++) {
            FloatBuffer texels = bytes.asFloatBuffer();
            for (int i = layer * count; i < (layer + 1) * count; i++) {
                texels.put(before.texels[i] + weight * (after.texels[i] - before.texels[i]));
            }
            texture.upload(firstLayer + layer, bytes);
        }
        MemoryUtil.memFree(bytes);
    }
}
