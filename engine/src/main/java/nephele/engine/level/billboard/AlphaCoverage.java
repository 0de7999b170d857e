package nephele.engine.level.billboard;

/**
 * The share of a picture that an alpha test draws, and how it is kept in smaller mipmap levels: their alpha is scaled
 * (Castaño 2010, "Computing Alpha Mipmaps"). Alpha is measured where it is drawn, interpolated between pixels.
 */
public final class AlphaCoverage {
    /** The least alpha that is drawn. */
    public static final double TEST = 0.5;

    /** Places along a side of a pixel. */
    private static final int PLACES = 4;

    private static final int HALVINGS = 14;
    private static final double MOST_SCALE = 64;

    private final int width;
    private final int height;
    private final byte[] rgba;

    private AlphaCoverage(int width, int height, byte[] rgba) {
        this.width = width;
        this.height = height;
        this.rgba = rgba;
    }

    /** Returns the drawn share of a picture, 0 to 1. @param rgba 8 bits a channel */
    public static double of(int width, int height, byte[] rgba) {
        return new AlphaCoverage(width, height, rgba).drawn(1);
    }

    /** Scales a level's alpha so that its drawn share becomes, as nearly as can be, {@code coverage}. */
    public static void keep(double coverage, int width, int height, byte[] rgba) {
        AlphaCoverage level = new AlphaCoverage(width, height, rgba);
        double low = 0;
        double high = MOST_SCALE;
        for (int i = 0; i < HALVINGS; i++) {
            double middle = i == 0 ? 1 : (low + high) / 2;
            if (level.drawn(middle) < coverage) {
                low = middle;
            } else {
                high = middle;
            }
        }
        double scale = level.drawn(high) - coverage < coverage - level.drawn(low) ? high : low;
        for (int i = 3; i < rgba.length; i += 4) {
            rgba[i] = (byte) scaled(rgba[i] & 0xff, scale);
        }
    }

    private static int scaled(int code, double scale) {
        return (int) Math.min(255, Math.round(code * scale));
    }

    private int alpha(int x, int y, double scale) {
        int column = Math.min(Math.max(x, 0), width - 1);
        int row = Math.min(Math.max(y, 0), height - 1);
        return scaled(rgba[4 * (row * width + column) + 3] & 0xff, scale);
    }

    private double drawn(double scale) {
        long count = 0;
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                count += drawnPlaces(x, y, scale);
            }
        }
        return count / (double) ((long) width * height * PLACES * PLACES);
    }

    /** Counts the drawn places between a pixel's middle and those of its right and lower neighbours. */
    private int drawnPlaces(int x, int y, double scale) {
        int a = alpha(x, y, scale);
        int b = alpha(x + 1, y, scale);
        int c = alpha(x, y + 1, scale);
        int d = alpha(x + 1, y + 1, scale);
        int limit = (int) Math.ceil(255 * TEST);
        if (Math.min(Math.min(a, b), Math.min(c, d)) >= limit) {
            return PLACES * PLACES;
        } else if (Math.max(Math.max(a, b), Math.max(c, d)) < 255 * TEST) {
            return 0;
        }
        int count = 0;
        for (int i = 0; i < PLACES * PLACES; i++) {
            double u = (i % PLACES + 0.5) / PLACES;
            double v = (i / PLACES + 0.5) / PLACES;
            double upper = a + (b - a) * u;
            double lower = c + (d - c) * u;
            count += upper + (lower - upper) * v >= 255 * TEST ? 1 : 0;
        }
        return count;
    }
}
