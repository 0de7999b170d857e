package nephele.engine.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.DoubleConsumer;
import nephele.engine.reference.SampleSequence.PixelSample;
import nephele.engine.reference.SampleSequence.Point;
import org.joml.Vector3d;

/** Traces a picture, row by row on several threads; the result does not depend on their number. */
public final class ReferencePicture {
    /** Raise it whenever a picture of any level changes: traced pictures are stored under it. */
    public static final int VERSION = 2;

    private static final Point MIDDLE = new Point(0.5, 0.5);

    private final TracedLevel level;
    private final Pinhole eye;
    private final TraceSettings settings;
    private final DoubleConsumer progress;
    private final SampleSequence sequence;
    private final float[] rgb;
    private final AtomicInteger nextRow = new AtomicInteger();
    private final AtomicInteger rowsDone = new AtomicInteger();

    private ReferencePicture(TracedLevel level, Pinhole eye, TraceSettings settings, DoubleConsumer progress) {
        this.level = level;
        this.eye = eye;
        this.settings = settings;
        this.progress = progress;
        sequence = new SampleSequence(settings.seed());
        rgb = new float[3 * settings.width() * settings.height()];
    }

    /**
     * Returns linear radiance before exposure, RGB, the bottom row first.
     *
     * @param progress receives the completed fraction, 0–1, from any thread
     */
    public static float[] trace(TracedLevel level, Pinhole eye, TraceSettings settings, DoubleConsumer progress) {
        ReferencePicture picture = new ReferencePicture(level, eye, settings, progress);
        picture.run();
        return picture.rgb;
    }

    private void run() {
        ExecutorService threads = Executors.newFixedThreadPool(settings.threads());
        try {
            List<Callable<Void>> workers = new ArrayList<>();
            for (int i = 0; i < settings.threads(); i++) {
                workers.add(this::work);
            }
            for (Future<Void> worker : threads.invokeAll(workers)) {
                worker.get();
            }
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("tracing was interrupted", stopped);
        } catch (ExecutionException failure) {
            throw new IllegalStateException("tracing failed: " + failure.getCause(), failure.getCause());
        } finally {
            threads.shutdownNow();
        }
    }

    private Void work() {
        Tracer tracer = level.tracer(eye);
        for (int row = nextRow.getAndIncrement(); row < settings.height(); row = nextRow.getAndIncrement()) {
            for (int column = 0; column < settings.width(); column++) {
                pixel(tracer, column, row);
            }
            progress.accept((double) rowsDone.incrementAndGet() / settings.height());
        }
        return null;
    }

    /** Computes the mean over the square of the pixel. */
    private void pixel(Tracer tracer, int column, int row) {
        Vector3d sum = new Vector3d();
        for (int i = 0; i < settings.samples(); i++) {
            PixelSample sample = sequence.sample(column, row, i);
            Point in = settings.samples() == 1 ? MIDDLE : sample.inPixel();
            Vector3d direction =
                    eye.direction((column + in.x()) / settings.width(), (row + in.y()) / settings.height());
            sum.add(tracer.radiance(direction, sample));
        }
        int at = 3 * (row * settings.width() + column);
        rgb[at] = (float) (sum.x / settings.samples());
        rgb[at + 1] = (float) (sum.y / settings.samples());
        rgb[at + 2] = (float) (sum.z / settings.samples());
    }
}
