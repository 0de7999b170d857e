package nephele.editor.panel;

import java.awt.image.BufferedImage;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import javax.swing.SwingWorker;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;

/** Small versions of a level's pictures, decoded on another thread when they are first asked for. */
final class Thumbnails {
    static final int SIDE_PIXELS = 96;

    private final Map<String, BufferedImage> known = new HashMap<>();
    private final Runnable arrived;
    private AssetSource assets;

    /** @param arrived called on the event dispatch thread when a picture can be shown */
    Thumbnails(Runnable arrived) {
        this.arrived = arrived;
    }

    /** Forgets all pictures if they are of other files. */
    void of(AssetSource files) {
        if (files != assets) {
            assets = files;
            known.clear();
        }
    }

    /** Returns the small picture; empty while it is decoded, and for good if it cannot be. */
    Optional<BufferedImage> find(String assetId) {
        if (!known.containsKey(assetId)) {
            known.put(assetId, null);
            load(assetId, assets);
        }
        return Optional.ofNullable(known.get(assetId));
    }

    private void load(String assetId, AssetSource from) {
        new SwingWorker<Optional<BufferedImage>, Void>() {
            @Override
            protected Optional<BufferedImage> doInBackground() {
                try {
                    return Optional.of(reduced(PictureDecoder.decode(assetId, from.bytes(assetId))));
                } catch (AssetException missing) {
                    // The problems panel tells of it.
                    return Optional.empty();
                }
            }

            @Override
            protected void done() {
                try {
                    if (from == assets) {
                        get().ifPresent(picture -> known.put(assetId, picture));
                        arrived.run();
                    }
                } catch (InterruptedException stopped) {
                    Thread.currentThread().interrupt();
                } catch (ExecutionException failed) {
                    throw new IllegalStateException("cannot make a small picture of " + assetId, failed.getCause());
                }
            }
        }.execute();
    }

    /** Returns the picture with the mean of each block of pixels, on {@link #SIDE_PIXELS} by as many. */
    static BufferedImage reduced(Picture picture) {
        Picture rgba = picture.toRgba8();
        BufferedImage small = new BufferedImage(SIDE_PIXELS, SIDE_PIXELS, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < SIDE_PIXELS; y++) {
            for (int x = 0; x < SIDE_PIXELS; x++) {
                small.setRGB(x, y, mean(rgba, x, y));
            }
        }
        return small;
    }

    private static int mean(Picture rgba, int x, int y) {
        int left = x * rgba.width() / SIDE_PIXELS;
        int top = y * rgba.height() / SIDE_PIXELS;
        int right = Math.max(left + 1, (x + 1) * rgba.width() / SIDE_PIXELS);
        int bottom = Math.max(top + 1, (y + 1) * rgba.height() / SIDE_PIXELS);
        int colour = 0;
        for (int channel = 0; channel < 3; channel++) {
            int sum = 0;
            for (int row = top; row < bottom; row++) {
                for (int column = left; column < right; column++) {
                    sum += rgba.sample(column, row, channel);
                }
            }
            colour = colour << 8 | sum / ((right - left) * (bottom - top));
        }
        return colour;
    }
}
