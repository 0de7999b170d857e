package nephele.scenes.xml;

import nephele.engine.asset.TextFile;

/** The text of a scene, without zero characters. */
final class XmlText {
    private XmlText() {}

    static String of(byte[] bytes, SceneWarnings warnings) {
        if (bytes.length > XmlSceneFile.MOST_BYTES) {
            int mebibytes = XmlSceneFile.MOST_BYTES >> 20;
            throw warnings.error(0, "the file has more than " + mebibytes + " MiB", "split the scene");
        }
        try {
            String text = TextFile.text(bytes);
            int zero = text.indexOf('\0');
            if (zero >= 0) {
                int line = 1
                        + (int) text.chars().limit(zero).filter(c -> c == '\n').count();
                throw warnings.error(line, "the file holds zero bytes instead of text", "restore it");
            }
            return text;
        } catch (TextFile.NotUtf8 noText) {
            throw warnings.error(noText.line(), "it can't be read", noText.getMessage());
        }
    }
}
