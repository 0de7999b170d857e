package nephele.workshop.prove.editor;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Function;
import javax.swing.JPanel;
import nephele.editor.window.dialog.DialogFrame.Content;
import nephele.editor.window.dialog.DialogOpener;

/** Takes the place of the screen for dialogues: random input goes to the one that is open until it is closed. */
final class DialogStage implements DialogOpener {
    private static final Dimension SIZE = new Dimension(700, 500);
    private static final int MOST_EVENTS = 12;

    private final SplittableRandom random;
    private Content content;
    private RandomPanelInput input;
    private String title = "";
    private int events;

    DialogStage(SplittableRandom random) {
        this.random = random;
    }

    @Override
    public void open(String of, Function<Runnable, Content> making) {
        title = of;
        events = 0;
        content = making.apply(() -> content = null);
        JPanel root = new JPanel(new BorderLayout());
        root.add(content.panel());
        root.setSize(SIZE);
        PaintedPanel.layOut(root);
        root.paint(new BufferedImage(SIZE.width, SIZE.height, BufferedImage.TYPE_INT_RGB).createGraphics());
        // The folder of the settings would be opened on the screen.
        input = new RandomPanelInput(root, random, List.of("open-folder"));
    }

    boolean isOpen() {
        return content != null;
    }

    /** Returns the last receiver in words. */
    String last() {
        return title + ": " + (input == null ? "" : input.last());
    }

    /** Sends an event to the open dialogue, or closes it. */
    void send() {
        events++;
        if (events > MOST_EVENTS) {
            content = null;
        } else if (content.main() != null && random.nextInt(4) == 0) {
            content.main().doClick(0);
        } else {
            input.send();
        }
    }
}
