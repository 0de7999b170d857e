package nephele.engine.measure;

/**
 * A picture in the linear opponent space YyCxCz (Monga, Geisler and Bovik 2010): achromatic, red–green, blue–yellow.
 *
 * @param y −16 at black, 100 at white
 */
record OpponentPicture(int width, float[] y, float[] cx, float[] cz) {
    static OpponentPicture of(LinearPicture picture) {
        int pixels = picture.pixels();
        var opponent = new OpponentPicture(picture.width(), new float[pixels], new float[pixels], new float[pixels]);
        float[] rgb = picture.rgb();
        for (int i = 0; i < pixels; i++) {
            double x = Colorimetry.relativeX(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]);
            double y = Colorimetry.relativeY(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]);
            double z = Colorimetry.relativeZ(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]);
            opponent.y[i] = (float) (116 * y - 16);
            opponent.cx[i] = (float) (500 * (x - y));
            opponent.cz[i] = (float) (200 * (y - z));
        }
        return opponent;
    }

    /** Returns CIELAB with the chroma of Hunt's effect (brighter colours look more colourful), three values a pixel. */
    float[] huntLab() {
        float[] lab = new float[3 * y.length];
        double[] colour = new double[3];
        for (int i = 0; i < y.length; i++) {
            double relativeY = (y[i] + 16.0) / 116;
            double relativeX = relativeY + cx[i] / 500.0;
            double relativeZ = relativeY - cz[i] / 200.0;
            Colorimetry.huntLab(relativeX, relativeY, relativeZ, colour);
            for (int channel = 0; channel < 3; channel++) {
                lab[3 * i + channel] = (float) colour[channel];
            }
        }
        return lab;
    }
}
