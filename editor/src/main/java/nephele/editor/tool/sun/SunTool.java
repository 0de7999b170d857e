package nephele.editor.tool.sun;

import java.util.List;
import nephele.editor.pane.Mark;
import nephele.editor.pane.MarkColour;
import nephele.editor.record.Entities;
import nephele.editor.text.Words;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.Tool;
import nephele.editor.tool.ToolContext;
import nephele.editor.tool.ToolEntry;
import nephele.engine.level.Level;
import nephele.engine.level.Sun;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/** Puts the sun where the pointer is in a perspective view; a level without a sun gets one. */
public final class SunTool implements Tool {
    public static final ToolEntry ENTRY = new ToolEntry(
            "sun",
            Words.of("Sun", "Sol", "Sol"),
            Words.of(
                    "Drag in a perspective view to put the sun there",
                    "Arraste numa vista em perspectiva para pôr o sol ali",
                    "Arrasta numa vista em perspetiva para pôr o sol ali"),
            "U",
            SunTool::new);

    private static final Words MOVE = Words.of("Move sun", "Mover sol", "Mover o sol");
    private static final String SECTION = "environment.sun";
    private static final Vec3 DAYLIGHT = new Vec3(3, 2.9, 2.6);
    /** Digits of the direction, a hundredth of a degree. */
    private static final double STEPS = 1e4;

    private final ToolContext context;
    private boolean isPressed;
    /** The sun's apparent place, a few metres before the eye; {@code null} without a drag. */
    private Vec3 sunMark;

    public SunTool(ToolContext context) {
        this.context = context;
    }

    @Override
    public void pressed(Pointer pointer) {
        isPressed = !pointer.isPlan();
        if (isPressed) {
            dragged(pointer);
        } else {
            context.status(ENTRY.description());
        }
    }

    @Override
    public void dragged(Pointer pointer) {
        if (!isPressed) {
            return;
        }
        Ray ray = pointer.ray();
        Vec3 towardsSun = new Vec3(rounded(ray.directionX()), rounded(ray.directionY()), rounded(ray.directionZ()));
        sunMark = ray.at(10);
        context.document().drag(before -> before.with(lit(before.level(), towardsSun)));
    }

    private static double rounded(double component) {
        return Math.rint(component * STEPS) / STEPS + 0.0;
    }

    private Level lit(Level level, Vec3 towardsSun) {
        Sun now = level.environment().sun();
        Sun moved = now == null
                ? new Sun(towardsSun, DAYLIGHT, true)
                : new Sun(towardsSun, now.irradiance(), now.castsShadow());
        return moved.equals(now) ? level : Entities.LEVEL.added(level, SECTION, moved);
    }

    @Override
    public void released(Pointer pointer) {
        if (isPressed) {
            context.document().commitDrag(MOVE);
        }
        isPressed = false;
        sunMark = null;
    }

    @Override
    public void cancel() {
        context.document().cancelDrag();
        isPressed = false;
        sunMark = null;
    }

    @Override
    public List<Mark> marks() {
        return sunMark == null ? List.of() : List.of(new Mark.Handle(sunMark, MarkColour.GUIDE));
    }

    @Override
    public Words hint() {
        return ENTRY.description();
    }
}
