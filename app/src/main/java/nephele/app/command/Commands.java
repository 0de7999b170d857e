package nephele.app.command;

import java.util.List;
import java.util.Optional;

/** Every command in the order of the help text; the only registration. */
public final class Commands {
    public static final List<CommandEntry> ALL = List.of(
            new CommandEntry("play", "Play the game", PlayCommand::new, PlayCommand::preload),
            new CommandEntry("render", "Draw one picture offscreen", RenderCommand::new, Preload::offscreenGraphics),
            new CommandEntry("check", "Print the problems of levels", CheckCommand::new),
            new CommandEntry("explain", "Say which features a level requires, and why", ExplainCommand::new),
            new CommandEntry("simulate", "Play a replay without graphics and print hashes", SimulateCommand::new),
            new CommandEntry("bench", "Measure a level's frames", BenchCommand::new),
            new CommandEntry("prove", "Run the proofs at full count and write docs/proofs.md", ProveCommand::new),
            new CommandEntry("edit", "Edit a level: edit [LEVEL]", UnbuiltCommand::new),
            new CommandEntry("trade", "Report speed against accuracy: trade [SUBJECT...] --out DIR", TradeCommand::new),
            new CommandEntry(
                    "bake", "Bake the sky into a skybox, and whatever a level caches: bake LEVEL", UnbuiltCommand::new),
            new CommandEntry(
                    "generate", "Make a primitive mesh: generate SHAPE NUMBER... OUT.3d", GenerateCommand::new),
            new CommandEntry(
                    "scene",
                    "View an XML scene: scene [FILE.xml [ENTITY.xml [BACKGROUND]]]",
                    SceneCommand::new,
                    SceneCommand::preload),
            new CommandEntry(
                    "import", "Turn an XML scene into a level: import FILE.xml --out LEVEL.json", ImportCommand::new));

    private Commands() {}

    public static Optional<CommandEntry> named(String name) {
        return ALL.stream().filter(entry -> entry.name().equals(name)).findFirst();
    }
}
