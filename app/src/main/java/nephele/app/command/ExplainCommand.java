package nephele.app.command;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.choice.CloudExplanation;
import nephele.engine.level.Hint;
import nephele.engine.level.Level;
import nephele.engine.level.PortalGun;
import nephele.engine.level.json.NumberText;
import nephele.engine.math.Vec3;
import nephele.engine.render.FramePlan;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.scene.light.LevelLight;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.StoredLight;
import nephele.engine.sim.state.Assist;
import nephele.host.draw.QualityChoice;
import nephele.host.named.LevelName;
import nephele.host.terminal.ExitCode;
import nephele.host.terminal.Terminal;
import picocli.CommandLine.Parameters;

/**
 * Prints which features a level requires, and why, whether its portals slide to floors, which clouds its weather means,
 * and what players are told.
 */
@picocli.CommandLine.Command
final class ExplainCommand implements Command {
    @Parameters(arity = "1", paramLabel = "LEVEL", description = "A level file.")
    private String level;

    @Override
    public ExitCode run(Terminal terminal) {
        var opened = new LevelName(level).open();
        boolean hasSurfaces = LightRequirements.hasSurfaces(opened.level());
        StoredLight light = hasSurfaces ? LevelLight.stored(opened.placed()) : null;
        FramePlan.of(FrameRequest.of(
                        opened.placed(),
                        light == null ? null : light.light(),
                        QualityChoice.defaultOutput(opened.level())))
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
        if (light != null) {
            terminal.out().println(light.line(level));
        }
        CloudExplanation.lines(opened.placed()).forEach(terminal.out()::println);
        guidance(opened.level()).forEach(terminal.out()::println);
        return ExitCode.DONE;
    }

    /** Returns what a player is told: where the goal's key points, and which hints are offered when. */
    private static List<String> guidance(Level level) {
        List<String> lines = new ArrayList<>();
        if (level.landmark() != null) {
            lines.add("goal: its key points at the landmark, "
                    + text(level.landmark().position()));
        }
        for (Hint hint : level.hints()) {
            lines.add("hint '" + hint.id() + "': offered after " + NumberText.of(hint.afterSeconds()) + " s"
                    + (hint.near() == null
                            ? ""
                            : " within " + NumberText.of(hint.near().radiusMetres()) + " m of "
                                    + text(hint.near().position())));
        }
        return lines;
    }

    private static String text(Vec3 place) {
        return "[" + NumberText.of(place.x()) + ", " + NumberText.of(place.y()) + ", " + NumberText.of(place.z()) + "]";
    }
}
