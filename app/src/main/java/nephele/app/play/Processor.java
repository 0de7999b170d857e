package nephele.app.play;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** The processor, as what was learned on it is filed. */
final class Processor {
    private Processor() {}

    /** Returns its model and the number of its cores, such as {@code AMD EPYC × 2}. */
    static String name() {
        String model = listed().or(() -> Optional.ofNullable(System.getenv("PROCESSOR_IDENTIFIER")))
                .orElse(System.getProperty("os.arch"));
        return model + " × " + Runtime.getRuntime().availableProcessors();
    }

    private static Optional<String> listed() {
        try (var lines = Files.lines(Path.of("/proc/cpuinfo"))) {
            return lines.filter(line -> line.startsWith("model name"))
                    .findFirst()
                    .map(line -> line.substring(line.indexOf(':') + 1).strip());
        } catch (IOException notLinux) {
            return Optional.empty();
        }
    }
}
