package nephele.workshop.prove.editor;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import nephele.editor.action.EditorCommand;
import nephele.editor.action.ProvingActions;
import nephele.editor.document.EntityBounds;
import nephele.editor.pane.PaneCamera.PanePoint;
import nephele.editor.pane.PaneLayout;
import nephele.editor.pane.PaneLayout.PaneRectangle;
import nephele.editor.problem.LevelProblem;
import nephele.editor.problem.ProblemSearch;
import nephele.editor.proving.TracedCorner;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSetting;
import nephele.editor.text.Words;
import nephele.editor.window.file.FileDrops;
import nephele.engine.math.Aabb;

/**
 * Sends seeded random input to an editor, one event a call: mouse, wheel, keys, commands, panels, sizes, settings,
 * problems, dropped files; to a dialogue while one is open.
 */
final class RandomEvents {
    private static final int[] KEYS = {
        KeyEvent.VK_ESCAPE,
        KeyEvent.VK_ENTER,
        KeyEvent.VK_DELETE,
        KeyEvent.VK_TAB,
        KeyEvent.VK_SPACE,
        KeyEvent.VK_UP,
        KeyEvent.VK_DOWN,
        KeyEvent.VK_LEFT,
        KeyEvent.VK_RIGHT,
        KeyEvent.VK_OPEN_BRACKET,
        KeyEvent.VK_CLOSE_BRACKET,
        KeyEvent.VK_MINUS
    };
    /** These take minutes: the traced corner has an event of its own. A picture would need a window. */
    private static final List<String> LEFT_OUT = List.of("trade", "path-trace", "screenshot");

    private static final int TRACED_SAMPLES = 1;
    private static final double NEAR_PIXELS = 90;
    private static final int[] SCALES = {100, 125, 150, 200};

    private final EditorUnderEvents editor;
    private final SplittableRandom random;
    private final RandomPanelInput panels;
    private final Supplier<Path> dropped;
    private final FileDrops drops;
    /** Problems of the level, which may be those before the last edits. */
    private List<LevelProblem> problems = List.of();

    private final DialogStage dialogues;
    /** The button of the drag in progress; 0 without one. */
    private int held;

    private int x;
    private int y;
    private String last = "";

    /** @param dropped chooses the next file to drop */
    RandomEvents(EditorUnderEvents editor, SplittableRandom random, Supplier<Path> dropped) {
        this.editor = editor;
        this.random = random;
        panels = new RandomPanelInput(editor.panel(), random, LEFT_OUT);
        this.dropped = dropped;
        EditorSession session = editor.session();
        drops = new FileDrops(session, editor.panel().viewport(), random::nextBoolean, session::status);
        dialogues = editor.dialogues();
    }

    /** Returns the last event in words, to find a failure's cause. */
    String last() {
        return last.isEmpty() ? panels.last() : last;
    }

    /** Sends the next event. */
    void send() {
        if (dialogues.isOpen()) {
            dialogues.send();
            last = "dialogue " + dialogues.last();
            return;
        }
        boolean drags = held != 0 && random.nextInt(100) < 80;
        if (drags) {
            drag();
            return;
        }
        int kind = random.nextInt(1000);
        if (kind < 330) {
            press();
        } else if (kind < 400) {
            placeAnywhere();
            mouse(MouseEvent.MOUSE_MOVED, 0, 0);
        } else if (kind < 450) {
            wheel();
        } else if (kind < 610) {
            key();
        } else if (kind < 740) {
            command();
        } else if (kind < 950) {
            last = "";
            panels.send();
        } else if (kind < 962) {
            last = "a problem";
            last = problem();
        } else if (kind < 967) {
            last = "a drop";
            last = drop();
        } else if (kind < 970) {
            last = trace();
        } else if (kind < 980) {
            Dimension size = new Dimension(500 + random.nextInt(700), 350 + random.nextInt(450));
            last = "resize " + size;
            editor.resize(size);
        } else if (kind < 985) {
            int percent = SCALES[random.nextInt(SCALES.length)];
            last = "scale " + percent;
            EditorSession session = session();
            session.settings(session.settings().with(EditorSetting.SCALE_PERCENT, percent));
        } else {
            run("open");
        }
    }

    private EditorSession session() {
        return editor.session();
    }

    private Component viewport() {
        return editor.panel().viewport().surface().component();
    }

    private int modifiers() {
        int all = 0;
        if (random.nextInt(3) == 0) {
            all |= random.nextBoolean() ? InputEvent.SHIFT_DOWN_MASK : 0;
            all |= random.nextBoolean() ? InputEvent.CTRL_DOWN_MASK : 0;
            all |= random.nextBoolean() ? InputEvent.ALT_DOWN_MASK : 0;
        }
        return all;
    }

    private void press() {
        if (held != 0) {
            release();
            return;
        }
        placeAnywhere();
        held = random.nextInt(4) > 0 ? MouseEvent.BUTTON1 : 1 + random.nextInt(3);
        mouse(MouseEvent.MOUSE_PRESSED, held, modifiers());
    }

    private void drag() {
        int what = random.nextInt(10);
        if (what < 7) {
            x += random.nextInt(121) - 60;
            y += random.nextInt(121) - 60;
            mouse(MouseEvent.MOUSE_DRAGGED, held, modifiers());
        } else {
            release();
        }
    }

    private void release() {
        mouse(MouseEvent.MOUSE_RELEASED, held, modifiers());
        held = 0;
    }

    private void mouse(int id, int button, int modifiers) {
        int mask = button == 0 || id == MouseEvent.MOUSE_RELEASED ? 0 : InputEvent.getMaskForButton(button);
        int clicks = random.nextInt(8) == 0 ? 2 : 1;
        Component target = viewport();
        MouseEvent event = new MouseEvent(target, id, 0, modifiers | mask, x, y, clicks, false, button);
        last = event.paramString() + " with " + session().toolEntry().id();
        target.dispatchEvent(event);
    }

    private void wheel() {
        placeAnywhere();
        Component target = viewport();
        int notches = random.nextInt(7) - 3;
        last = "wheel " + notches + " at " + x + "," + y;
        target.dispatchEvent(new MouseWheelEvent(
                target,
                MouseEvent.MOUSE_WHEEL,
                0,
                modifiers(),
                x,
                y,
                0,
                false,
                MouseWheelEvent.WHEEL_UNIT_SCROLL,
                3,
                notches));
    }

    /** Takes any place of the viewport, or one near the picture of an entity, where there is something to grab. */
    private void placeAnywhere() {
        Component target = viewport();
        x = random.nextInt(Math.max(1, target.getWidth()));
        y = random.nextInt(Math.max(1, target.getHeight()));
        List<EntityRef> all = entities();
        List<PaneRectangle> places = session().panes().rectangles(session().viewport(), PaneLayout.GAP_PIXELS);
        if (all.isEmpty() || places.isEmpty() || random.nextInt(3) == 0) {
            return;
        }
        Aabb box = Entities.LEVEL
                .find(session().document().level(), all.get(random.nextInt(all.size())))
                .map(EntityBounds::of)
                .orElse(Aabb.EMPTY);
        if (!box.isEmpty()) {
            near(places.get(random.nextInt(places.size())), box);
        }
    }

    private List<EntityRef> entities() {
        List<EntityRef> selected = session().document().selection().entities();
        boolean takesSelected = !selected.isEmpty() && random.nextBoolean();
        return takesSelected
                ? selected
                : Entities.LEVEL.all(session().document().level());
    }

    private void near(PaneRectangle place, Aabb box) {
        session()
                .panes()
                .views()
                .get(place.index())
                .camera()
                .project(box.centre(), place.size())
                .ifPresent(projected -> place(place, projected));
    }

    private void place(PaneRectangle place, PanePoint projected) {
        double inX = projected.x() + (random.nextDouble() - 0.5) * NEAR_PIXELS;
        double inY = projected.y() + (random.nextDouble() - 0.5) * NEAR_PIXELS;
        if (inX >= 0 && inX < place.width() && inY >= 0 && inY < place.height()) {
            x = (int) (place.x() + inX);
            y = (int) (place.y() + inY);
        }
    }

    private void key() {
        int code = random.nextInt(3) == 0 ? KEYS[random.nextInt(KEYS.length)] : letterOrDigit();
        int id = random.nextInt(6) == 0 ? KeyEvent.KEY_RELEASED : KeyEvent.KEY_PRESSED;
        KeyEvent event = new KeyEvent(editor.panel(), id, 0, modifiers(), code, (char) code);
        last = event.paramString();
        if (editor.panel().keys().find(event).filter(LEFT_OUT::contains).isEmpty()) {
            editor.panel().key(event);
        }
    }

    private int letterOrDigit() {
        int of = random.nextInt(36);
        return of < 26 ? KeyEvent.VK_A + of : KeyEvent.VK_0 + of - 26;
    }

    private void command() {
        List<EditorCommand> all = editor.panel().commands().all();
        run(all.get(random.nextInt(all.size())).id());
    }

    private void run(String id) {
        if (!LEFT_OUT.contains(id)) {
            last = "command " + id + " with " + session().toolEntry().id();
            editor.panel().commands().named(id).ifPresent(EditorCommand::run);
        }
    }

    /** Drops a file; returns the event in words. */
    private String drop() {
        Path file = dropped.get();
        int width = Math.max(1, editor.panel().viewport().getWidth());
        int height = Math.max(1, editor.panel().viewport().getHeight());
        drops.drop(List.of(file), new Point(random.nextInt(width + 20), random.nextInt(height + 20)));
        return "drop " + file.getFileName();
    }

    /** Chooses, fixes or hides a problem, which may be one of a level before the last edits; returns it in words. */
    private String problem() {
        EditorSession session = session();
        if (problems.isEmpty() || random.nextInt(3) == 0) {
            problems = session.background()
                    .get(() -> ProblemSearch.of(session.document().level(), session.assets()));
            session.proving().problems().found(problems);
        }
        if (problems.isEmpty()) {
            return "no problem";
        }
        LevelProblem problem = problems.get(random.nextInt(problems.size()));
        int what = random.nextInt(4);
        if (what == 0) {
            ProvingActions.choose(session, problem);
        } else if (what == 1) {
            session.document().edit(Words.same("hide"), level -> LevelProblem.hide(level, problem));
        } else if (!problem.fixes().isEmpty()) {
            LevelProblem.Fix fix =
                    problem.fixes().get(random.nextInt(problem.fixes().size()));
            session.document().edit(fix.label(), fix.change());
        }
        return "problem " + what + ": " + problem.path() + " " + problem.message();
    }

    /** Shows the path-traced corner, which is slow, or takes it away. */
    private String trace() {
        TracedCorner corner = session().proving().corner();
        corner.show(!corner.isVisible(), TRACED_SAMPLES);
        return "traced corner " + corner.isVisible();
    }
}
