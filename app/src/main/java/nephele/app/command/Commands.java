package nephele.app.command;

import java.util.List;
import nephele.host.terminal.CommandFailure;
import nephele.host.terminal.ExitCode;
import nephele.host.terminal.Terminal;
import picocli.CommandLine.Unmatched;

/**
 * All commands in the order of the help text; the only registration. The entries are lambdas, because a constructor
 * reference loads and links the command's class, and with BenchCommand the lab module.
 */
public final class Commands {
    public static final List<CommandEntry> ALL = List.of(
            new CommandEntry("play", "Play the game", () -> new PlayCommand(), () -> PlayCommand.preload()),
            new CommandEntry(
                    "render", "Draw one picture offscreen", () -> new RenderCommand(), Preload::offscreenGraphics),
            new CommandEntry("check", "Print the problems of levels", () -> new CheckCommand()),
            new CommandEntry("explain", "Say which features a level requires, and why", () -> new ExplainCommand()),
            new CommandEntry(
                    "simulate", "Play a replay without graphics and print hashes", () -> new SimulateCommand()),
            new CommandEntry("bench", "Measure a level's frames", () -> new BenchCommand()),
            new CommandEntry(
                    "prove", "Run the proofs at full count and write docs/proofs.md", () -> new ProofsOfCheckout()),
            new CommandEntry("edit", "Edit a level: edit [LEVEL], or run a script of edits", () -> new EditCommand()),
            new CommandEntry(
                    "trade", "Report speed against accuracy: trade [SUBJECT...] --out DIR", () -> new TradeCommand()),
            new CommandEntry(
                    "bake",
                    "Bake a level's sky into a skybox, or its light: bake LEVEL --sky NAME | --light",
                    () -> new BakeCommand()),
            new CommandEntry(
                    "generate",
                    "Make a primitive mesh or a height map: generate SHAPE NUMBER... OUT.3d",
                    () -> new GenerateCommand()),
            new CommandEntry(
                    "scene",
                    "View an XML scene: scene [FILE.xml [ENTITY.xml [BACKGROUND]]]",
                    () -> new SceneCommand(),
                    () -> SceneCommand.preload()),
            new CommandEntry(
                    "import",
                    "Turn an XML scene into a level: import FILE.xml --out LEVEL.json",
                    () -> new ImportCommand()));

    private Commands() {}

    /** Refuses to prove from the jar, which has no proofs, and names the start script that builds and runs them. */
    @picocli.CommandLine.Command
    private static final class ProofsOfCheckout implements Command {
        /** The rest of the command line, whatever it is. */
        @Unmatched
        private List<String> words;

        @Override
        public ExitCode run(Terminal terminal) {
            throw CommandFailure.environment(
                    "proofs run from a checkout of the sources, which this jar is not: type ./nephele prove there");
        }
    }
}
