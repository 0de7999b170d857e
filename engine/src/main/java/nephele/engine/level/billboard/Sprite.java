package nephele.engine.level.billboard;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.level.Billboards;
import nephele.engine.math.Vec3;

/**
 * The pictures of a group's billboards as 8-bit RGBA with straight alpha. Transparent pixels have the colours of the
 * nearest visible ones, so that filtering draws no fringe of the colour key.
 *
 * @param frames of equal size
 */
public record Sprite(int width, int height, List<Picture> frames) {
    public Sprite {
        frames = List.copyOf(frames);
    }

    /**
     * Reads a group's picture.
     *
     * @throws nephele.engine.asset.AssetException that names a picture that cannot be used
     */
    public static Sprite of(Billboards group, AssetSource assets) {
        return PictureDecoder.inMemory(group.sprite(), () -> read(group, assets));
    }

    private static Sprite read(Billboards group, AssetSource assets) {
        Picture stored = PictureDecoder.decode(group.sprite(), assets.bytes(group.sprite()));
        boolean hasAlpha = stored.channels() == 2 || stored.channels() == 4;
        Picture keyed = stored.toRgba8();
        Vec3 key = group.colourKey() == null && !hasAlpha ? Vec3.ZERO : group.colourKey();
        if (key != null) {
            keyed = keyed(keyed, key);
        }
        // A picture of another width has been reported; its rest is left out here.
        int width = Math.max(1, keyed.width() / group.frames());
        List<Picture> frames = new ArrayList<>();
        for (int i = 0; i < Math.min(group.frames(), keyed.width()); i++) {
            frames.add(ColourSpread.over(cut(keyed, i * width, width)));
        }
        return new Sprite(width, keyed.height(), frames);
    }

    private static Picture keyed(Picture picture, Vec3 key) {
        byte[] samples = picture.samples().clone();
        byte red = code(key.x());
        byte green = code(key.y());
        byte blue = code(key.z());
        for (int i = 0; i < samples.length; i += 4) {
            if (samples[i] == red && samples[i + 1] == green && samples[i + 2] == blue) {
                samples[i + 3] = 0;
            }
        }
        return new Picture(picture.width(), picture.height(), 4, 8, samples);
    }

    private static byte code(double value) {
        return (byte) Math.round(255 * value);
    }

    private static Picture cut(Picture picture, int left, int width) {
        byte[] samples = new byte[4 * width * picture.height()];
        for (int y = 0; y < picture.height(); y++) {
            System.arraycopy(picture.samples(), 4 * (y * picture.width() + left), samples, 4 * y * width, 4 * width);
        }
        return new Picture(width, picture.height(), 4, 8, samples);
    }
}
