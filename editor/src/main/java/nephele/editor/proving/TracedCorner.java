package nephele.editor.proving;

import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Supplier;
import nephele.editor.text.Words;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.Picture;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.engine.reference.TracedExposure;
import nephele.engine.reference.TracedLevel;
import nephele.engine.render.Capture;
import nephele.host.draw.QualityChoice;

/**
 * The path-traced picture in a corner of the perspective pane. It begins again after a change of the camera or of the
 * level, coarse at first, and becomes finer by itself.
 */
public final class TracedCorner {
    /** Samples per pixel after which the picture is finished. */
    private static final int ENOUGH_SAMPLES = 1024;

    private static final double FRACTION_OF_PANE = 0.38;
    private static final int WIDEST_PIXELS = 400;
    private static final int MOST_SAMPLES_AT_ONCE = 16;
    private static final int PREVIEW_DIVISOR = 4;

    /** The mean of traced pictures, weighted by their samples. */
    static final class TraceProgress {
        private final int width;
        private final double[] sum;
        private int samples;

        TraceProgress(int width, int height) {
            this.width = width;
            sum = new double[3 * width * height];
        }

        int samples() {
            return samples;
        }

        void add(float[] radiance, int itsSamples) {
            for (int i = 0; i < sum.length; i++) {
                sum[i] += (double) radiance[i] * itsSamples;
            }
            samples += itsSamples;
        }

        Picture picture(Level level) {
            float[] mean = new float[sum.length];
            for (int i = 0; i < sum.length; i++) {
                mean[i] = (float) (sum[i] / samples);
            }
            return picture(mean, width, level);
        }

        /** Returns radiance, the bottom row first, as the engine would display it. */
        static Picture picture(float[] radiance, int width, Level level) {
            BufferedImage image =
                    Capture.toneMapped(radiance, width, level.environment(), QualityChoice.defaultOutput(level));
            byte[] rgb = new byte[3 * width * image.getHeight()];
            for (int i = 0; i < width * image.getHeight(); i++) {
                int colour = image.getRGB(i % width, i / width);
                rgb[3 * i] = (byte) (colour >> 16);
                rgb[3 * i + 1] = (byte) (colour >> 8);
                rgb[3 * i + 2] = (byte) colour;
            }
            return new Picture(width, image.getHeight(), 3, 8, rgb);
        }
    }

    private final ProvingSubject subject;
    private final Supplier<ProvingThreads> threads;
    private boolean isVisible;
    private int enough = ENOUGH_SAMPLES;
    private Wanted wanted;

    /** The number of the last run; an older one ends when it has changed. */
    private volatile int running;

    private Traced traced;
    /** The last level prepared for tracing; camera movements use it again. */
    private volatile Prepared prepared;

    /** The inputs of the picture. */
    private record Wanted(Level level, AssetSource assets, PaneEye eye) {
        boolean isSame(Wanted other) {
            return other != null && level == other.level && assets == other.assets && eye.equals(other.eye);
        }
    }

    private record Prepared(Level level, AssetSource assets, PlacedLevel placed, TracedLevel traced) {
        /** Returns what an eye sees: for an exposure that its picture decides, another level. */
        Prepared exposedFor(PaneEye eye) {
            if (!TracedExposure.isNeeded(level)) {
                return this;
            }
            PlacedLevel exposed = TracedExposure.fixed(placed, ColourDecoding.SRGB, eye.pinhole(), 0);
            return new Prepared(exposed.level(), assets, exposed, TracedLevel.of(exposed, ColourDecoding.SRGB));
        }
    }

    /**
     * The picture as far as it is.
     *
     * @param samples per pixel; 0 for the coarse picture at the beginning
     */
    public record Traced(Picture picture, int samples) {}

    TracedCorner(ProvingSubject subject, Supplier<ProvingThreads> threads) {
        this.subject = subject;
        this.threads = threads;
    }

    public boolean isVisible() {
        return isVisible;
    }

    /** Shows the picture or takes it away. */
    public void show(boolean visible) {
        show(visible, ENOUGH_SAMPLES);
    }

    /** Shows the picture up to a number of samples per pixel, or takes it away. */
    public void show(boolean visible, int samples) {
        isVisible = visible;
        enough = samples;
        wanted = null;
        traced = null;
        running = running + 1;
        if (isVisible) {
            follow();
        }
        subject.redraw();
    }

    /** Returns the picture; empty while there is none. */
    public Optional<Traced> traced() {
        return isVisible ? Optional.ofNullable(traced) : Optional.empty();
    }

    /** Returns the picture if it belongs to a pane. */
    public Optional<Traced> traced(int pane) {
        return PaneEye.of(subject).pane() == pane ? traced() : Optional.empty();
    }

    void follow() {
        if (!isVisible || !subject.isSettled()) {
            return;
        }
        Wanted next = new Wanted(subject.level(), subject.assets(), PaneEye.of(subject));
        if (next.isSame(wanted)) {
            return;
        }
        wanted = next;
        int run = running + 1;
        running = run;
        int most = enough;
        threads.get().work().execute(() -> trace(run, next, most));
    }

    private void trace(int run, Wanted what, int most) {
        try {
            Prepared exposed = prepared(what).exposedFor(what.eye);
            TracedLevel level = exposed.traced;
            requireWanted(run);
            int width = (int) Math.min(
                    WIDEST_PIXELS,
                    Math.max(16, FRACTION_OF_PANE * what.eye.size().width()));
            int height = (int) Math.max(9, Math.round(width / what.eye.size().aspect()));
            TraceProgress sum = new TraceProgress(width, height);
            float[] coarse = rays(
                    run, level, what, new TraceSettings(width / PREVIEW_DIVISOR, height / PREVIEW_DIVISOR, 1, 1, 1));
            show(run, new Traced(TraceProgress.picture(coarse, width / PREVIEW_DIVISOR, exposed.level), 0));
            while (sum.samples() < most) {
                int samples =
                        Math.min(Math.min(MOST_SAMPLES_AT_ONCE, Math.max(1, sum.samples())), most - sum.samples());
                sum.add(
                        rays(run, level, what, new TraceSettings(width, height, samples, sum.samples() + 1, 1)),
                        samples);
                show(run, new Traced(sum.picture(exposed.level), sum.samples()));
            }
        } catch (CancellationException cancelled) {
            return;
        } catch (AssetException | IllegalArgumentException unusable) {
            threads.get().session().execute(() -> subject.status(Words.same(unusable.getMessage())));
        }
    }

    private Prepared prepared(Wanted what) {
        Prepared known = prepared;
        if (known == null || known.level != what.level || known.assets != what.assets) {
            PlacedLevel placed = PlacedLevel.of(what.level, what.assets);
            known = new Prepared(what.level, what.assets, placed, TracedLevel.of(placed, ColourDecoding.SRGB));
            prepared = known;
        }
        return known;
    }

    private void requireWanted(int run) {
        if (run != running) {
            throw new CancellationException("the camera or the level has changed");
        }
    }

    /** Traces on one thread, and gives way to everything else. */
    private float[] rays(int run, TracedLevel level, Wanted what, TraceSettings settings) {
        try {
            return ReferencePicture.trace(level, what.eye.pinhole(), settings, fraction -> {
                Thread.currentThread().setPriority(Thread.MIN_PRIORITY);
                requireWanted(run);
            });
        } catch (IllegalStateException stopped) {
            requireWanted(run);
            throw stopped;
        }
    }

    private void show(int run, Traced next) {
        threads.get().session().execute(() -> {
            if (run == running) {
                traced = next;
                subject.redraw();
            }
        });
    }
}
