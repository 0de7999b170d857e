package nephele.engine.measure;

/**
 * The contrast sensitivity of an observer at {@link Flip#PIXELS_PER_DEGREE}: filters the three opponent channels by
 * sums of Gaussians (Andersson et al. 2020, section 4.1.1, after Johnson and Fairchild 2003).
 */
final class ContrastFilter {
    /** A Gaussian a·√(π/b)·exp(−π²x²/b), x in degrees of visual angle. */
    private record Gaussian(double a, double b) {
        double weight(double degrees) {
            return Math.exp(-Math.PI * Math.PI * degrees * degrees / b);
        }

        int radius(double pixelsPerDegree) {
            return (int) Math.ceil(3 * Math.sqrt(b / (2 * Math.PI * Math.PI)) * pixelsPerDegree);
        }
    }

    private static final Gaussian ACHROMATIC = new Gaussian(1, 0.0047);
    private static final Gaussian RED_GREEN = new Gaussian(1, 0.0053);
    private static final Gaussian[] BLUE_YELLOW = {new Gaussian(34.1, 0.04), new Gaussian(13.5, 0.025)};

    private final int radius;
    private final double pixelsPerDegree;
    private final Kernel achromatic;
    private final Kernel redGreen;
    private final Kernel[] blueYellow;
    private final float firstBlueYellowShare;

    ContrastFilter(double pixelsPerDegree) {
        this.pixelsPerDegree = pixelsPerDegree;
        radius = BLUE_YELLOW[0].radius(pixelsPerDegree);
        achromatic = kernel(ACHROMATIC);
        redGreen = kernel(RED_GREEN);
        blueYellow = new Kernel[] {kernel(BLUE_YELLOW[0]), kernel(BLUE_YELLOW[1])};
        double first = volume(BLUE_YELLOW[0]);
        firstBlueYellowShare = (float) (first / (first + volume(BLUE_YELLOW[1])));
    }

    private Kernel kernel(Gaussian gaussian) {
        int own = Math.min(radius, 2 * gaussian.radius(pixelsPerDegree));
        return Kernel.of(own, pixel -> gaussian.weight(pixel / pixelsPerDegree));
    }

    /** Returns the sum of the unnormalised weights of the two-dimensional filter. */
    private double volume(Gaussian gaussian) {
        double sum = 0;
        for (int pixel = -radius; pixel <= radius; pixel++) {
            sum += gaussian.weight(pixel / pixelsPerDegree);
        }
        return gaussian.a() * Math.sqrt(Math.PI / gaussian.b()) * sum * sum;
    }

    /** Filters the three channels in place. */
    void apply(OpponentPicture picture) {
        float[] rows = new float[picture.y().length];
        inPlace(achromatic, picture.y(), picture.width(), rows);
        inPlace(redGreen, picture.cx(), picture.width(), rows);
        float[] narrow = picture.cz().clone();
        inPlace(blueYellow[0], picture.cz(), picture.width(), rows);
        inPlace(blueYellow[1], narrow, picture.width(), rows);
        float[] cz = picture.cz();
        for (int i = 0; i < cz.length; i++) {
            cz[i] = firstBlueYellowShare * cz[i] + (1 - firstBlueYellowShare) * narrow[i];
        }
    }

    private static void inPlace(Kernel kernel, float[] channel, int width, float[] rows) {
        kernel.alongRows(channel, width, rows);
        kernel.alongColumns(rows, width, channel);
    }
}
