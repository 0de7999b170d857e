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

    byte[] colours(AtlasImage image) {
        byte[] bytes = new byte[4 * image.side() * image.side()];
        for (int i = 0; i < bytes.length / 4; i++) {
            int x = i % image.side();
            int y = i / image.side();
            for (int channel = 0; channel < AtlasImage.ALPHA; channel++) {
                float value = Math.min(1, image.value(x, y, channel));
                bytes[4 * i + channel] = codes[Math.round(value * STEPS)];
            }
            bytes[4 * i + 3] = (byte) Math.round(255 * image.value(x, y, AtlasImage.ALPHA));
        }
        return bytes;
    }

    byte[] shapes(AtlasImage image) {
        byte[] bytes = new byte[4 * image.side() * image.side()];
        for (int i = 0; i < bytes.length / 4; i++) {
            for (int channel = 0; channel < 4; channel++) {
                float value = image.value(i % image.side(), i / image.side(), AtlasImage.ALPHA + 1 + channel);
                bytes[4 * i + channel] = (byte) Math.round(127.5 + 127.5 * Math.max(-1, Math.min(1, value)));
            }
        }
        return bytes;
    }
}
