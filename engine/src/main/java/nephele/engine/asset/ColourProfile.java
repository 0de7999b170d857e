package nephele.engine.asset;

import java.awt.color.ColorSpace;
import java.awt.color.ICC_Profile;
import java.awt.image.ColorConvertOp;
import java.awt.image.ColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.DataBufferByte;
import java.awt.image.DataBufferUShort;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;

/**
 * An ICC profile, which says what colours the numbers of a picture are. Pictures become sRGB; one whose profile cannot
 * be used, or differs from sRGB by less than is seen, keeps its numbers. This is the only class that uses
 * {@code java.awt.color}, the JDK's colour management, which needs no window toolkit.
 */
final class ColourProfile {
    private static final int MOST_BYTES = 4 << 20;

    /** The largest difference, of 255, up to which a profile counts as sRGB. */
    private static final int SAME = 2;

    /** Values of each channel of the colours that are tried. */
    private static final int TRIED = 5;

    private final ColorConvertOp toSrgb;

    private ColourProfile(ICC_Profile profile) {
        this.toSrgb =
                new ColorConvertOp(new ICC_Profile[] {profile, ICC_Profile.getInstance(ColorSpace.CS_sRGB)}, null);
    }

    /** Returns the profile; {@code null} if there is none or it is damaged. */
    private static ColourProfile of(byte[] bytes, int channels) {
        if (bytes == null || bytes.length > MOST_BYTES) {
            return null;
        }
        try {
            ICC_Profile profile = ICC_Profile.getInstance(bytes);
            int kind =
                    channels == 1 ? ColorSpace.TYPE_GRAY : channels == 3 ? ColorSpace.TYPE_RGB : ColorSpace.TYPE_CMYK;
            if (profile.getColorSpaceType() != kind) {
                return null;
            }
            ColourProfile usable = new ColourProfile(profile);
            usable.converted(raster(1, 1, channels, 8, new byte[channels], channels));
            return usable;
        } catch (RuntimeException damaged) {
            return null;
        }
    }

    /** Returns the number of colour channels of a grey or RGB model; 0 for any other colour space. */
    static int colours(ColorModel model) {
        int space = model.getColorSpace().getType();
        return space == ColorSpace.TYPE_GRAY ? 1 : space == ColorSpace.TYPE_RGB ? 3 : 0;
    }

    /**
     * Returns a picture in sRGB.
     *
     * @param profile {@code null} for none
     */
    static Picture toSrgb(Picture picture, byte[] profile) {
        int channels = picture.channels() < 3 ? 1 : 3;
        ColourProfile known = of(profile, channels);
        if (known == null || known.isSrgb(channels)) {
            return picture;
        }
        int bits = picture.bitsPerChannel();
        Raster colours = known.converted(
                raster(picture.width(), picture.height(), channels, bits, picture.samples(), picture.channels()));
        return replaced(picture, channels, colours);
    }

    /**
     * Returns the picture of four inks.
     *
     * @param inks cyan, magenta, yellow and black of each pixel; 255 covers it
     * @param profile {@code null} for inks that filter light independently
     */
    static Picture ofInks(int width, int height, byte[] inks, byte[] profile) {
        ColourProfile known = of(profile, 4);
        byte[] samples = new byte[3 * width * height];
        if (known != null) {
            Raster colours = known.converted(raster(width, height, 4, 8, inks, 4));
            return replaced(new Picture(width, height, 3, 8, samples), 3, colours);
        }
        for (int pixel = 0; pixel < width * height; pixel++) {
            int light = 255 - (inks[4 * pixel + 3] & 0xff);
            for (int channel = 0; channel < 3; channel++) {
                int filtered = light * (255 - (inks[4 * pixel + channel] & 0xff));
                samples[3 * pixel + channel] = (byte) ((filtered + 127) / 255);
            }
        }
        return new Picture(width, height, 3, 8, samples);
    }

    private boolean isSrgb(int channels) {
        int count = channels == 1 ? 256 : TRIED * TRIED * TRIED;
        byte[] tried = new byte[count * channels];
        for (int i = 0; i < count; i++) {
            for (int channel = 0, rest = i; channel < channels; channel++, rest /= TRIED) {
                tried[i * channels + channel] = (byte) (channels == 1 ? i : rest % TRIED * 255 / (TRIED - 1));
            }
        }
        byte[] colours = ((DataBufferByte) converted(raster(count, 1, channels, 8, tried, channels))
                        .getDataBuffer())
                .getData();
        for (int i = 0; i < count; i++) {
            for (int channel = 0; channel < 3; channel++) {
                int was = tried[i * channels + Math.min(channel, channels - 1)] & 0xff;
                if (Math.abs(was - (colours[3 * i + channel] & 0xff)) > SAME) {
                    return false;
                }
            }
        }
        return true;
    }

    private WritableRaster converted(Raster numbers) {
        WritableRaster colours = Raster.createInterleavedRaster(
                numbers.getTransferType(), numbers.getWidth(), numbers.getHeight(), 3, null);
        return toSrgb.filter(numbers, colours);
    }

    /** @param stride channels of each pixel in {@code samples}, of which the raster has the first */
    private static WritableRaster raster(int width, int height, int channels, int bits, byte[] samples, int stride) {
        int type = bits == 8 ? DataBuffer.TYPE_BYTE : DataBuffer.TYPE_USHORT;
        WritableRaster raster = Raster.createInterleavedRaster(type, width, height, channels, null);
        byte[] bytes = bits == 8 ? ((DataBufferByte) raster.getDataBuffer()).getData() : null;
        short[] shorts = bits == 8 ? null : ((DataBufferUShort) raster.getDataBuffer()).getData();
        for (int pixel = 0; pixel < width * height; pixel++) {
            for (int channel = 0; channel < channels; channel++) {
                int at = pixel * stride + channel;
                if (bits == 8) {
                    bytes[pixel * channels + channel] = samples[at];
                } else {
                    shorts[pixel * channels + channel] = (short) (samples[2 * at] & 0xff | samples[2 * at + 1] << 8);
                }
            }
        }
        return raster;
    }

    /** Returns the picture with the first {@code channels} of each pixel replaced; its alpha stays. */
    private static Picture replaced(Picture picture, int channels, Raster colours) {
        byte[] samples = picture.samples().clone();
        boolean isWide = picture.bitsPerChannel() == 16;
        byte[] bytes = isWide ? null : ((DataBufferByte) colours.getDataBuffer()).getData();
        short[] shorts = isWide ? ((DataBufferUShort) colours.getDataBuffer()).getData() : null;
        for (int pixel = 0; pixel < picture.width() * picture.height(); pixel++) {
            for (int channel = 0; channel < channels; channel++) {
                int at = pixel * picture.channels() + channel;
                if (isWide) {
                    samples[2 * at] = (byte) shorts[3 * pixel + channel];
                    samples[2 * at + 1] = (byte) (shorts[3 * pixel + channel] >> 8);
                } else {
                    samples[at] = bytes[3 * pixel + channel];
                }
            }
        }
        return new Picture(picture.width(), picture.height(), picture.channels(), picture.bitsPerChannel(), samples);
    }
}
