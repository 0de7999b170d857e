package nephele.editor.surface;

import java.awt.EventQueue;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JSplitPane;

/** A window with a viewport, in a process of its own; prints a line for each scenario. */
public final class CanvasScenarios {
    private static final List<String> REPORTS = new ArrayList<>();

    private CanvasScenarios() {}

    public static void main(String[] words) throws Exception {
        FillPainter painter = new FillPainter();
        int status = 1;
        try {
            EventQueue.invokeAndWait(() -> run(painter));
            status = 0;
        } finally {
            // The dispatch thread would keep the process alive after a failure.
            System.exit(status);
        }
    }

    private static void run(FillPainter painter) {
        JFrame frame = new JFrame("viewport");
        ViewportSurface surface = ViewportSurfaces.choose(SurfaceMode.AUTO, painter, REPORTS::add);
        JSplitPane split = new JSplitPane(JSplitPane.HORIZONTAL_SPLIT, surface.component(), new JPanel());
        frame.setContentPane(split);
        frame.setSize(400, 300);
        split.setDividerLocation(200);
        frame.setVisible(true);
        frame.validate();
        BufferedImage picture = surface.picture();
        tell("picture", picture.getRGB(5, 5) == 0xff0000ff && picture.getWidth() >= 190, painter);
        tell("opened once", count(painter, "opened") == 1, painter);
        int live = painter.live();
        split.setDividerLocation(120);
        frame.validate();
        surface.picture();
        tell("resized", surface.size().width() < 150 && painter.live() == live, painter);
        split.remove(surface.component());
        boolean isCanvas = REPORTS.isEmpty();
        tell("taken away", !isCanvas || count(painter, "closing") == 1 && painter.live() == 0, painter);
        split.setLeftComponent(surface.component());
        split.setDividerLocation(120);
        frame.validate();
        painter.red = 0;
        picture = surface.picture();
        tell("added again", (picture.getRGB(5, picture.getHeight() - 5) & 0xffffff) == 0x003300, painter);
        tell("as many objects", painter.live() == live, painter);
        surface.close();
        tell("closed", painter.live() == 0, painter);
        frame.dispose();
        System.out.println(REPORTS.isEmpty() ? "canvas" : String.join(" ", REPORTS));
    }

    private static long count(FillPainter painter, String event) {
        return painter.events.stream().filter(event::equals).count();
    }

    private static void tell(String scenario, boolean isFine, FillPainter painter) {
        System.out.println(scenario + ": " + (isFine ? "ok" : painter.events + " " + REPORTS));
    }
}
