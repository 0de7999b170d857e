package nephele.engine.scene.impostor;

import nephele.engine.level.appearance.ColourDecoding;

/** The bytes in which atlases are stored. */
final class AtlasCodes {
    private AtlasCodes() {}

    static byte[] colours(AtlasImage image, ColourDecoding.Codes codes) {
        byte[] bytes = new byte[4 * image.side() * image.side()];
        for (int i = 0; i < bytes.length / 4; i++) {
            int x = i % image.side();
            int y = i / image.side();
            for (int channel = 0; channel < AtlasImage.ALPHA; channel++) {
                bytes[4 * i + channel] = codes.nearest(image.value(x, y, channel));
            }
            bytes[4 * i + 3] = (byte) Math.round(255 * image.value(x, y, AtlasImage.ALPHA));
        }
        return bytes;
    }

    static byte[] shapes(AtlasImage image) {
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
