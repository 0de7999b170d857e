package nephele.app.trade.run;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import nephele.app.prove.Surroundings;

/** Which code is running: what was measured with other code does not count. */
final class CodeState {
    private CodeState() {}

    /** The commit; where the code is not exactly that commit's, also when the program was built. */
    static String key() {
        String commit = Surroundings.commit();
        return commit.matches("[0-9a-f]+") ? commit : commit + " built " + built();
    }

    private static String built() {
        try {
            var source = CodeState.class.getProtectionDomain().getCodeSource();
            return source == null
                    ? ""
                    : Files.getLastModifiedTime(Path.of(source.getLocation().toURI()))
                            .toString();
        } catch (IOException | URISyntaxException unknown) {
            return "";
        }
    }
}
