package nephele.editor.widget;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Supplier;
import javax.swing.Icon;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;

/** Small pictures of a level's pictures, read in the background; used by the event dispatch thread. */
public final class AssetPictures {
    private static final int KEPT_PIXELS = 96;
    private static final BufferedImage NONE = new BufferedImage(1, 1, BufferedImage.TYPE_INT_ARGB);

    private final Supplier<AssetSource> assets;
    private final Executor background;
    private final Map<String, BufferedImage> pictures = new HashMap<>();
    private AssetSource source;

    /** @param background reads the pictures */
    public AssetPictures(Supplier<AssetSource> assets, Executor background) {
        this.assets = assets;
        this.background = background;
    }

    /** Returns the picture of an asset, which appears when it has been read. */
    public Icon icon(String assetId, int sidePoints) {
        return new Icon() {
            @Override
            public void paintIcon(Component component, Graphics graphics, int x, int y) {
                find(assetId, component).ifPresent(picture -> {
                    Graphics2D g = (Graphics2D) graphics.create();
                    g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
                    g.drawImage(picture, x, y, getIconWidth(), getIconHeight(), null);
                    g.dispose();
                });
            }

            @Override
            public int getIconWidth() {
                return UIScale.scale(sidePoints);
            }

            @Override
            public int getIconHeight() {
                return getIconWidth();
            }
        };
    }

    /**
     * Returns the picture of an asset, opaque and square; empty while it is read.
     *
     * @param component its parent is repainted when the picture has been read
     */
    public Optional<BufferedImage> find(String assetId, Component component) {
        AssetSource now = assets.get();
        if (source != now) {
            source = now;
            pictures.clear();
        }
        BufferedImage known = pictures.putIfAbsent(assetId, NONE);
        if (known == null) {
            Component parent = component.getParent() == null ? component : component.getParent();
            background.execute(() -> {
                BufferedImage read = read(now, assetId);
                EventQueue.invokeLater(() -> {
                    if (source == now) {
                        pictures.put(assetId, read);
                        parent.repaint();
                    }
                });
            });
        }
        return Optional.ofNullable(known);
    }

    /** Returns an empty picture if the asset cannot be read; the problems panel tells why. */
    private static BufferedImage read(AssetSource assets, String assetId) {
        try {
            return small(PictureDecoder.decode(assetId, assets.bytes(assetId)).toRgba8());
        } catch (AssetException | IllegalArgumentException unreadable) {
            return NONE;
        }
    }

    /** Returns the mean colour of each cell, opaque. */
    private static BufferedImage small(Picture picture) {
        int side = Math.min(KEPT_PIXELS, Math.max(picture.width(), picture.height()));
        BufferedImage image = new BufferedImage(side, side, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < side; y++) {
            for (int x = 0; x < side; x++) {
                image.setRGB(x, y, mean(picture, x, y, side));
            }
        }
        return image;
    }

    private static int mean(Picture picture, int cellX, int cellY, int side) {
        int left = cellX * picture.width() / side;
        int right = Math.max(left + 1, (cellX + 1) * picture.width() / side);
        int top = cellY * picture.height() / side;
        int bottom = Math.max(top + 1, (cellY + 1) * picture.height() / side);
        int rgb = 0;
        for (int channel = 0; channel < 3; channel++) {
            long sum = 0;
            for (int y = top; y < bottom; y++) {
                for (int x = left; x < right; x++) {
                    sum += picture.sample(x, y, channel);
                }
            }
            rgb = rgb << 8 | (int) (sum / ((long) (right - left) * (bottom - top)));
        }
        return rgb;
    }
}
