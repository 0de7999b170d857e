package nephele.editor.window;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import javax.swing.JSeparator;
import javax.swing.JToggleButton;
import javax.swing.SwingConstants;
import nephele.editor.action.EditorCommand;
import nephele.editor.action.EditorCommands;
import nephele.editor.action.EditorKeys;
import nephele.editor.document.Grid;
import nephele.editor.panel.model.NumberExpression;
import nephele.editor.session.EditorSession;
import nephele.editor.widget.WordCell;
import nephele.engine.level.Language;

/** The bar below the toolbar: how the active pane looks, panes, snapping, grid, and the options of the tool in use. */
final class OptionBar extends JPanel {
    private static final long serialVersionUID = 1;

    /** Groups of the view, in order; the step of the grid is chosen between the last two. */
    private static final List<List<String>> VIEW = List.of(
            List.of("lit", "unlit", "portalable", "collision", "wireframe"),
            List.of("one-pane", "two-panes", "four-panes"),
            List.of("snap-grid", "snap-vertex", "snap-surface", "snap-absolute"));
    /** Actions that do something at once instead of choosing a state. */
    private static final List<String> MOMENTARY = List.of(
            "texture-pick",
            "texture-fit",
            "texture-left",
            "texture-centre",
            "texture-right",
            "texture-top",
            "texture-middle",
            "texture-bottom",
            "texture-reset",
            "terrain-smaller",
            "terrain-larger",
            "terrain-weaker",
            "terrain-stronger");

    private static final List<String> TEXTURES =
            MOMENTARY.stream().filter(id -> id.startsWith("texture-")).toList();
    private static final List<String> TEXTURE_LOCK = List.of("texture-lock");
    private static final Map<String, List<String>> OF_TOOL = Map.of(
            "terrain",
            List.of(
                    "terrain-raise",
                    "terrain-lower",
                    "terrain-smooth",
                    "terrain-flatten",
                    "terrain-paint",
                    "terrain-erase",
                    "terrain-smaller",
                    "terrain-larger",
                    "terrain-weaker",
                    "terrain-stronger"),
            "brush",
            List.of(
                    "shape-box",
                    "shape-wedge",
                    "shape-stairs",
                    "shape-arch",
                    "shape-cylinder",
                    "shape-room",
                    "new-portalable"),
            "clip",
            List.of("keep-behind", "keep-front", "keep-both"),
            "paint",
            Stream.concat(TEXTURES.stream(), TEXTURE_LOCK.stream()).toList(),
            "portalable",
            List.of("new-portalable"),
            "select",
            TEXTURE_LOCK,
            "move",
            TEXTURE_LOCK,
            "rotate",
            TEXTURE_LOCK,
            "scale",
            TEXTURE_LOCK);

    private final transient EditorSession session;
    private final transient EditorCommands commands;
    private final transient List<CommandButton> buttons = new ArrayList<>();
    private final JComboBox<Double> grid = new JComboBox<>();
    private final LayerBox layers;
    private transient EditorKeys keys;
    private String filledTool = "";
    private boolean hasLayers;

    OptionBar(EditorSession session, EditorCommands commands) {
        super(new WrappingRow());
        this.session = session;
        this.commands = commands;
        setBorder(BorderFactory.createEmptyBorder(0, 4, 2, 4));
        for (double metres = Grid.FINEST_METRES; metres <= Grid.COARSEST_METRES; metres *= 2) {
            grid.addItem(metres);
        }
        grid.setRenderer(new WordCell<Double>(metres -> NumberExpression.text(metres) + " m"));
        // The widest text, "0.125 m", and the arrow.
        grid.setPrototypeDisplayValue(Grid.FINEST_METRES);
        layers = new LayerBox(session);
        grid.addActionListener(event -> {
            double step = (Double) grid.getSelectedItem();
            if (step != session.grid().stepMetres()) {
                session.grid(new Grid(step));
            }
        });
    }

    /** Fills the bar anew, with the keys and in the language of the session. */
    void fill(EditorKeys next) {
        keys = next;
        fill();
    }

    private void fill() {
        removeAll();
        buttons.clear();
        Language language = session.language();
        filledTool = session.toolEntry().id();
        getAccessibleContext().setAccessibleName(WindowText.OPTIONS.in(language));
        for (List<String> group : VIEW) {
            group(group);
            separator();
        }
        grid.setToolTipText(WindowText.GRID_STEP.in(language));
        grid.getAccessibleContext().setAccessibleName(WindowText.GRID_STEP.in(language));
        grid.updateUI();
        add(grid);
        if (!of(filledTool).isEmpty()) {
            separator();
            group(of(filledTool));
        }
        hasLayers = LayerBox.isOffered(session);
        if (hasLayers) {
            layers.setToolTipText(WindowText.LAYER_TO_PAINT.in(language));
            layers.getAccessibleContext().setAccessibleName(WindowText.LAYER_TO_PAINT.in(language));
            layers.updateUI();
            add(layers);
        }
        refresh();
        revalidate();
        repaint();
    }

    private void group(List<String> ids) {
        ids.forEach(id -> commands.named(id).ifPresent(this::add));
    }

    private void add(EditorCommand command) {
        AbstractButton button = MOMENTARY.contains(command.id()) ? new JButton() : new JToggleButton();
        CommandButton made = CommandButton.of(command, button, keys, session.language());
        button.addActionListener(event -> refresh());
        add(button);
        buttons.add(made);
    }

    private void separator() {
        JSeparator line = new JSeparator(SwingConstants.VERTICAL);
        line.setPreferredSize(new Dimension(line.getPreferredSize().width * 3, UIScale.scale(20)));
        add(line);
    }

    /** Shows what holds now; another tool brings its own options. */
    void refresh() {
        boolean isSame = filledTool.equals(session.toolEntry().id()) && hasLayers == LayerBox.isOffered(session);
        if (keys != null && !isSame) {
            fill();
            return;
        }
        buttons.forEach(CommandButton::refresh);
        grid.setSelectedItem(session.grid().stepMetres());
        if (hasLayers) {
            layers.refresh();
        }
    }

    /** Returns the ids of the actions of a tool, in order. */
    private static List<String> of(String tool) {
        return OF_TOOL.getOrDefault(tool, List.of());
    }
}
