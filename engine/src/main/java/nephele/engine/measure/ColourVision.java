package nephele.engine.measure;

/**
 * Colour vision, normal or without one kind of cone, simulated by the linear maps of Machado, Oliveira and Fernandes 2009
 * (table 1, severity 1) on linear sRGB.
 */
public enum ColourVision {
    NORMAL(1, 0, 0, 0, 1, 0, 0, 0, 1),
    PROTANOPIA(0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998),
    DEUTERANOPIA(0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881),
    TRITANOPIA(1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900);

    private final double[] map;

    ColourVision(double... map) {
        this.map = map;
    }

    /** Returns the CIE L* of a colour as this vision sees it, relative to the display's white. */
    public double lightness(double red, double green, double blue) {
        double y = Colorimetry.relativeY(
                channel(0, red, green, blue), channel(1, red, green, blue), channel(2, red, green, blue));
        return Colorimetry.lightness(y);
    }

    private double channel(int row, double red, double green, double blue) {
        double perceived = map[3 * row] * red + map[3 * row + 1] * green + map[3 * row + 2] * blue;
        return Math.max(0, Math.min(1, perceived));
    }
}
