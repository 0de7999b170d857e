package nephele.editor.panel;

import com.formdev.flatlaf.FlatClientProperties;
import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.awt.Component;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Insets;
import java.awt.RenderingHints;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.image.BufferedImage;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import javax.swing.AbstractButton;
import javax.swing.Icon;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JToggleButton;
import javax.swing.SwingConstants;
import nephele.editor.brush.ShapeOptions;
import nephele.editor.document.Registration;
import nephele.editor.paint.MaterialLibrary;
import nephele.editor.panel.model.PaletteEntry;
import nephele.editor.panel.model.PanelText;
import nephele.editor.record.Entities;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionChange;
import nephele.editor.session.Tools;
import nephele.editor.text.EntityWords;
import nephele.editor.widget.AssetPictures;
import nephele.editor.widget.EntityIcons;
import nephele.engine.level.Language;
import nephele.engine.level.Material;
import net.miginfocom.swing.MigLayout;

/**
 * Buttons for brush shapes, materials and kinds of entities. They set what the tools make next, and show it. Materials
 * of the level come before those of the library.
 */
public final class PalettePanel extends JPanel implements AutoCloseable {
    private static final long serialVersionUID = 1;
    private static final int SAMPLE_POINTS = 48;

    private final transient EditorSession session;
    private final transient Registration registration;
    private final JPanel content =
            new WidthTrackingPanel(new MigLayout("insets 4, gap 3, fillx, wrap 1", "[grow, fill]"));
    /** The buttons, each with the question whether what it sets is set. */
    private final transient Map<AbstractButton, BooleanSupplier> choices = new LinkedHashMap<>();

    private final transient AssetPictures pictures;
    private transient List<Material> listed = List.of();

    /** @param pictures of the textures of materials */
    public PalettePanel(EditorSession session, AssetPictures pictures) {
        super(new MigLayout("insets 4, fill", "[grow, fill]", "[grow, fill]"));
        this.session = session;
        this.pictures = pictures;
        add(new JScrollPane(content));
        // The number of columns follows from the width.
        content.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                content.revalidate();
            }
        });
        registration = session.listen(change -> {
            if (change == SessionChange.SETTINGS || session.document().level().materials() != listed) {
                refresh();
            } else if (change == SessionChange.VIEW) {
                showChosen();
            }
        });
        refresh();
    }

    private void refresh() {
        listed = session.document().level().materials();
        Language language = session.language();
        getAccessibleContext().setAccessibleName(PanelText.PALETTE.in(language));
        content.removeAll();
        choices.clear();
        JPanel shapes = group(PanelText.SHAPES.in(language), 2);
        shape(shapes, PanelText.ROOM, "room", new ShapeOptions.Room(0.5));
        shape(shapes, PanelText.BOX, "box", new ShapeOptions.Box());
        shape(shapes, PanelText.WEDGE, "wedge", new ShapeOptions.Wedge(null));
        shape(shapes, PanelText.STAIRS, "stairs", new ShapeOptions.Stairs(null, 8));
        shape(shapes, PanelText.ARCH, "arch", new ShapeOptions.Arch(12, 0.5));
        shape(shapes, PanelText.CYLINDER, "cylinder", new ShapeOptions.Cylinder(16));
        for (EntityWords.Group group : EntityWords.Group.values()) {
            List<PaletteEntry> entries = PaletteEntry.below(Entities.LEVEL, group);
            if (group == EntityWords.Group.SOLIDS) {
                materials(group(PanelText.MATERIALS.in(language), 3));
            }
            if (!entries.isEmpty()) {
                JPanel buttons = group(group.words().in(language), 2);
                entries.forEach(entry -> entity(buttons, entry));
            }
        }
        showChosen();
        content.revalidate();
        content.repaint();
    }

    /** Adds a heading; returns the panel below it. */
    private JPanel group(String text, int columns) {
        JLabel label = new JLabel(text);
        label.setFont(label.getFont().deriveFont(Font.BOLD));
        content.add(label, "gaptop 6");
        JPanel grid = new JPanel(new FittingGrid(columns));
        grid.setOpaque(false);
        content.add(grid, "wmin 0");
        return grid;
    }

    private void shape(JPanel grid, PanelText text, String symbol, ShapeOptions shape) {
        var button = new JToggleButton(text.in(session.language()), EntityIcons.ofShape(symbol));
        add(grid, button, () -> isUsed("brush", shape), () -> {
            session.options().shape(shape);
            take("brush");
        });
    }

    private boolean isUsed(String tool, ShapeOptions shape) {
        return session.toolEntry().id().equals(tool)
                && session.options().shape().equals(shape);
    }

    private void entity(JPanel grid, PaletteEntry entry) {
        var button =
                new JToggleButton(entry.words().in(session.language()), EntityIcons.of(entry.section(), entry.kind()));
        BooleanSupplier isChosen = () -> session.toolEntry().id().equals("place")
                && session.options().section().equals(entry.section())
                && session.options().kind().equals(entry.kind());
        add(grid, button, isChosen, () -> {
            session.options().entity(entry.section(), entry.kind());
            take("place");
        });
    }

    private void materials(JPanel grid) {
        material(grid, Material.DEFAULT_GREY, null, PanelText.GREY.in(session.language()));
        listed.forEach(material -> material(grid, material, material.id(), material.id()));
        MaterialLibrary.STANDARD
                .missingIn(session.document().level())
                .forEach(material -> material(grid, material, material.id(), material.id()));
    }

    private void material(JPanel grid, Material material, String chosen, String name) {
        BooleanSupplier isChosen = () -> Objects.equals(session.options().material(), chosen);
        var button = new JToggleButton(name, sample(material));
        button.setHorizontalTextPosition(SwingConstants.CENTER);
        button.setVerticalTextPosition(SwingConstants.BOTTOM);
        button.setIconTextGap(2);
        button.setMargin(new Insets(2, 0, 2, 0));
        button.setToolTipText(name);
        button.putClientProperty("JButton.buttonType", "toolBarButton");
        button.putClientProperty("FlatLaf.styleClass", "small");
        prepare(button, isChosen, () -> {
            session.options().material(chosen);
            session.tell(SessionChange.VIEW);
        });
        grid.add(button);
    }

    /** Returns the look of a material: its picture times its colour. */
    private Icon sample(Material material) {
        return new Icon() {
            @Override
            public void paintIcon(Component component, Graphics graphics, int x, int y) {
                Graphics2D g = (Graphics2D) graphics.create();
                g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
                int side = getIconWidth();
                Color colour = LinearColour.onScreen(material.baseColour());
                Optional<BufferedImage> picture =
                        Optional.ofNullable(material.texture()).flatMap(id -> pictures.find(id, component));
                g.setColor(colour);
                g.fillRect(x, y, side, side);
                picture.ifPresent(image -> g.drawImage(image, x, y, side, side, null));
                if (material.mirror()) {
                    g.setColor(new Color(255, 255, 255, 150));
                    g.fillPolygon(new int[] {x + side / 5, x + side / 2, x + side / 5}, new int[] {y + side, y, y}, 3);
                }
                g.setColor(Color.GRAY);
                g.drawRect(x, y, side - 1, side - 1);
                g.dispose();
            }

            @Override
            public int getIconWidth() {
                return UIScale.scale(SAMPLE_POINTS);
            }

            @Override
            public int getIconHeight() {
                return getIconWidth();
            }
        };
    }

    private void add(JPanel grid, AbstractButton button, BooleanSupplier isChosen, Runnable action) {
        button.setHorizontalAlignment(SwingConstants.LEADING);
        button.setToolTipText(button.getText());
        button.putClientProperty(FlatClientProperties.BUTTON_TYPE, FlatClientProperties.BUTTON_TYPE_TOOLBAR_BUTTON);
        button.setIconTextGap(UIScale.scale(6));
        prepare(button, isChosen, action);
        grid.add(button);
    }

    private void prepare(AbstractButton button, BooleanSupplier isChosen, Runnable action) {
        button.putClientProperty(FlatClientProperties.MINIMUM_WIDTH, 40);
        button.addActionListener(event -> {
            action.run();
            showChosen();
        });
        choices.put(button, isChosen);
    }

    private void showChosen() {
        choices.forEach((button, isChosen) -> button.setSelected(isChosen.getAsBoolean()));
    }

    private void take(String tool) {
        Tools.named(tool).ifPresent(session::use);
        session.tell(SessionChange.VIEW);
    }

    @Override
    public void close() {
        registration.close();
    }
}
