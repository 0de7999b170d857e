package nephele.app.command;

import nephele.engine.choice.CloudExplanation;
import nephele.engine.draw.Outputs;
import nephele.engine.level.PortalGun;
import nephele.engine.named.LevelName;
import nephele.engine.render.FramePlan;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.sim.state.Assist;
import nephele.engine.terminal.ExitCode;
import nephele.engine.terminal.Terminal;
import picocli.CommandLine.Parameters;

/** Prints which features a level requires, and why, whether its portals slide to floors, and which clouds its weather means. */
@picocli.CommandLine.Command
final class ExplainCommand implements Command {
    @Parameters(arity = "1", paramLabel = "LEVEL", description = "A level file.")
    private String level;

    @Override
    public ExitCode run(Terminal terminal) {
        var opened = new LevelName(level).open();
        FramePlan.of(FrameRequest.of(opened.placed(), Outputs.defaultFor(opened.level())))
                .explain()
                .forEach(terminal.out()::println);
        PortalGun gun = opened.level().portalGun();
        if (gun != null) {
            terminal.out()
                    .println(Assist.PORTAL_TO_FLOOR.text()
                            + (gun.toFloor()
                                    ? ": required by portalGun: its portals slide down to floors"
                                    : ": not required: portalGun.toFloor is false"));
        }
        CloudExplanation.lines(opened.placed()).forEach(terminal.out()::println);
        return ExitCode.DONE;
    }
}
