package nephele.app.command;

import java.nio.file.Path;
import java.util.Locale;
import nephele.host.terminal.CommandFailure;
import nephele.host.terminal.ExitCode;
import nephele.host.terminal.Terminal;
import nephele.scenes.file.SceneImport;
import nephele.scenes.file.SceneName;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Turns an XML scene into a level. */
@picocli.CommandLine.Command
final class ImportCommand implements Command {
    @Parameters(index = "0", paramLabel = "FILE.xml", description = "A scene.")
    private String scene;

    @Option(
            names = "--out",
            required = true,
            paramLabel = "LEVEL.json",
            description = "The level to write; its meshes and pictures go beside it. An old one stays as .bak.")
    private Path out;

    @Override
    public ExitCode run(Terminal terminal) {
        if (!out.toString().toLowerCase(Locale.ROOT).endsWith(".json")) {
            throw CommandFailure.usage("--out must end in .json: " + out);
        }
        var imported = SceneImport.save(new SceneName(scene), out, terminal.err()::println);
        imported.written().forEach(file -> terminal.out().println("written: " + file));
        int models = imported.level().models().size();
        terminal.out().println(out + ": " + models + " models; play it with: nephele play " + word(out));
        return ExitCode.DONE;
    }

    /** Returns a file as one word of a command line, quoted if necessary for shells of any system. */
    private static String word(Path file) {
        String text = file.toString();
        return text.matches("[\\p{L}\\p{N}._/\\\\:-]+") ? text : '"' + text + '"';
    }
}
