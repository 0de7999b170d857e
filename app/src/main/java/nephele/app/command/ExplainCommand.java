package nephele.app.command;

import nephele.app.draw.Outputs;
import nephele.app.levels.LevelName;
import nephele.app.terminal.ExitCode;
import nephele.app.terminal.Terminal;
import nephele.engine.render.FramePlan;
import nephele.engine.render.frame.FrameRequest;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** Says which features a level requires, and why. */
@picocli.CommandLine.Command
final class ExplainCommand implements Command {
    @Parameters(arity = "1", paramLabel = "LEVEL", description = "A level file.")
    private String level;

    @Mixin
    private CommonOptions common;

    @Override
    public CommonOptions common() {
        return common;
    }

    @Override
    public ExitCode run(Terminal terminal) {
        var opened = new LevelName(level).open();
        FramePlan.of(FrameRequest.of(opened.level(), Outputs.requiredBy(opened.level())))
                .explain()
                .forEach(terminal.out()::println);
        return ExitCode.DONE;
    }
}
