package nephele.engine.scene.impostor;

import nephele.engine.level.appearance.ColourDecoding;

/** The bytes in which atlases are stored. */
final class AtlasCodes {
    private static final int STEPS = 4096;

    /** The code of each linear value i / {@value #STEPS}. */
    private final byte[] codes = new byte[STEPS + 1];

    AtlasCodes(ColourDecoding decoding) {
        double[] linear = decoding.table();
        int code = 0;
        for (int i = 0; i <= STEPS; i++) {
            double value = (double) i / STEPS;
            while (code < 255 && (linear[code] + linear[code + 1]) / 2 <= value) {
                code++;
            }
            codes[i] = (byte) code;
        }
    }

    /** @param scale factor on coverage */
    byte[] colours(AtlasImage image, double scale) {
        byte[] bytes = new byte[4 * image.side() * image.side()];
        for (int i = 0; i < bytes.length / 4; i++) {
            int x = i % image.side();
            int y = i / image.side();
            float alpha = image.value(x, y, AtlasImage.ALPHA);
            double covered = Math.min(1, alpha * scale);
            double factor = alpha > 0 ? covered / alpha : 0;
            for (int channel = 0; channel < 3; channel++) {
                double value = Math.min(1, factor * image.value(x, y, channel));
                bytes[4 * i + channel] = codes[(int) Math.round(value * STEPS)];
            }
            bytes[4 * i + 3] = (byte) Math.round(255 * covered);
        }
        return bytes;
    }

    /** @param scale factor on coverage, and so on normals */
    byte[] shapes(AtlasImage image, double scale) {
        byte[] bytes = new byte[4 * image.side() * image.side()];
        for (int i = 0; i < bytes.length / 4; i++) {
            for (int channel = 0; channel < 4; channel++) {
                int x = i % image.side();
                int y = i / image.side();
                float alpha = image.value(x, y, AtlasImage.ALPHA);
                double factor = channel == 3 || alpha == 0 ? 1 : Math.min(1, alpha * scale) / alpha;
                double value = factor * image.value(x, y, 4 + channel);
                bytes[4 * i + channel] = (byte) Math.round(127.5 + 127.5 * Math.max(-1, Math.min(1, value)));
            }
        }
        return bytes;
    }
}
