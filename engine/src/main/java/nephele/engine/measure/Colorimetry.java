package nephele.engine.measure;

/**
 * Conversions between linear sRGB, CIE XYZ relative to its white (D65, so that white is 1, 1, 1) and CIELAB (CIE
 * 15:2004) with Hunt-adjusted chroma (Andersson et al. 2020, equation 6).
 */
final class Colorimetry {
    /** XYZ from linear sRGB, IEC 61966-2-1, by its primaries. */
    private static final double[][] XYZ_FROM_RGB = {
        {10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
        {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
        {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}
    };

    private static final double[][] RGB_FROM_XYZ = inverse(XYZ_FROM_RGB);
    private static final double[] WHITE = {sum(XYZ_FROM_RGB[0]), sum(XYZ_FROM_RGB[1]), sum(XYZ_FROM_RGB[2])};

    /** Below the cube of this, CIELAB replaces the cube root by a line. */
    private static final double KINK = 6.0 / 29;

    private Colorimetry() {}

    static double relativeX(double red, double green, double blue) {
        return dot(XYZ_FROM_RGB[0], red, green, blue) / WHITE[0];
    }

    static double relativeY(double red, double green, double blue) {
        return dot(XYZ_FROM_RGB[1], red, green, blue) / WHITE[1];
    }

    static double relativeZ(double red, double green, double blue) {
        return dot(XYZ_FROM_RGB[2], red, green, blue) / WHITE[2];
    }

    /** Writes L*, a*, b* of the nearest displayable colour: red, green and blue are clamped to 0–1 first. */
    static void huntLab(double x, double y, double z, double[] lab) {
        double red = unit(dot(RGB_FROM_XYZ[0], x * WHITE[0], y * WHITE[1], z * WHITE[2]));
        double green = unit(dot(RGB_FROM_XYZ[1], x * WHITE[0], y * WHITE[1], z * WHITE[2]));
        double blue = unit(dot(RGB_FROM_XYZ[2], x * WHITE[0], y * WHITE[1], z * WHITE[2]));
        double fx = compressed(relativeX(red, green, blue));
        double fy = compressed(relativeY(red, green, blue));
        double fz = compressed(relativeZ(red, green, blue));
        double lightness = 116 * fy - 16;
        lab[0] = lightness;
        lab[1] = 0.01 * lightness * 500 * (fx - fy);
        lab[2] = 0.01 * lightness * 200 * (fy - fz);
    }

    /** Returns L* of a luminance relative to white. */
    static double lightness(double relativeY) {
        return 116 * compressed(relativeY) - 16;
    }

    private static double compressed(double t) {
        return t > KINK * KINK * KINK ? Math.cbrt(t) : t / (3 * KINK * KINK) + 4.0 / 29;
    }

    private static double unit(double value) {
        return Math.min(Math.max(value, 0), 1);
    }

    private static double dot(double[] row, double a, double b, double c) {
        return row[0] * a + row[1] * b + row[2] * c;
    }

    private static double sum(double[] row) {
        return row[0] + row[1] + row[2];
    }

    private static double[][] inverse(double[][] m) {
        double[][] inverse = new double[3][3];
        double determinant = 0;
        for (int i = 0; i < 3; i++) {
            determinant += m[0][i] * cofactor(m, 0, i);
        }
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 3; column++) {
                inverse[row][column] = cofactor(m, column, row) / determinant;
            }
        }
        return inverse;
    }

    private static double cofactor(double[][] m, int row, int column) {
        int r1 = (row + 1) % 3;
        int r2 = (row + 2) % 3;
        int c1 = (column + 1) % 3;
        int c2 = (column + 2) % 3;
        return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
    }
}
