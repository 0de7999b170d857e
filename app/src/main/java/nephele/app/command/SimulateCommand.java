package nephele.app.command;

import java.io.BufferedOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.replay.StateDump;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimState;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;
import nephele.host.terminal.ExitCode;
import nephele.host.terminal.Terminal;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Plays a replay without graphics and prints the state's hash, and the tick in which the level ended. */
@picocli.CommandLine.Command
final class SimulateCommand implements Command {
    @Parameters(arity = "1", paramLabel = "LEVEL", description = "A level file.")
    private String level;

    @Option(
            names = "--replay",
            paramLabel = "FILE",
            description = "What the player does (default: the level's recorded walk, else 300 ticks of standing).")
    private String replay;

    @Option(
            names = "--every",
            paramLabel = "N",
            defaultValue = "1",
            description = "Print the hash every N ticks and at the last tick (default: 1).")
    @OptionRange.Whole(least = 1, most = Long.MAX_VALUE)
    private long every;

    @Option(names = "--dump", paramLabel = "FILE.json", description = "Write the last state.")
    private Path dump;

    @Override
    public ExitCode run(Terminal terminal) {
        var name = new LevelName(level);
        var opened = name.open();
        var inputs = replay == null ? name.recordedWalk() : LevelName.replay(replay);
        var replayFile = replay == null ? "the recorded walk of " + name.fileName() : replay;
        opened.requireRecordedHere(inputs, replayFile, terminal.err());
        var last = play(opened, inputs, terminal);
        if (dump != null) {
            WrittenFile.text(dump, StateDump.of(last).write());
        }
        return ExitCode.DONE;
    }

    private SimState play(OpenedLevel opened, Replay inputs, Terminal terminal) {
        var simulation = new Simulation(SimLevel.of(opened.placed()), inputs.settings());
        var lines = new PrintStream(new BufferedOutputStream(terminal.out(), 1 << 16), false, StandardCharsets.UTF_8);
        var last = inputs.play(simulation, Replay.hashes(every, inputs.ticks(), lines::println));
        if (inputs.ticks() == 0) {
            lines.println(Replay.hashLine(last));
        }
        lines.flush();
        if (last.world().exit().isReached()) {
            terminal.err().println("exit " + last.world().exit().tick());
        }
        return last;
    }
}
