package nephele.workshop.prove.editor;

import java.awt.Component;
import java.awt.Container;
import java.awt.Insets;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.JViewport;
import javax.swing.ListCellRenderer;
import javax.swing.ScrollPaneConstants;
import nephele.editor.record.Entities;
import nephele.editor.session.EditorSession;

/**
 * Searches for texts that do not fit: less room than the preferred size asks for, or a place that is partly outside of
 * the container. Texts of the user may be cut if their tooltip, or the field's caret, shows the whole.
 */
public final class CutTexts {
    private static final Pattern NUMBER = Pattern.compile("[-+]?[0-9.,]+");

    /** The ids of the user's entities. */
    private final Set<String> ids;

    private final List<String> found = new ArrayList<>();

    private CutTexts(Set<String> ids) {
        this.ids = ids;
    }

    /** Returns a line for each text within a container that has been laid out and is cut off; only paths are the user's. */
    public static List<String> in(Container container) {
        return in(container, Set.of());
    }

    /** Returns the same where the ids of the level that a session has open are the user's, too. */
    public static List<String> in(Container container, EditorSession session) {
        Set<String> ids = new HashSet<>();
        Entities.LEVEL.all(session.document().level()).forEach(ref -> ids.add(ref.id()));
        ids.remove("");
        return in(container, ids);
    }

    private static List<String> in(Container container, Set<String> ids) {
        CutTexts search = new CutTexts(ids);
        search.within(container);
        return search.found;
    }

    /** Returns true if a text names something of the user: an id of the level, or a path of files. */
    private boolean isOfUser(String text) {
        return text.indexOf('/') >= 0 || ids.stream().anyMatch(text::contains);
    }

    private void within(Container container) {
        for (Component child : container.getComponents()) {
            if (child.isVisible()) {
                requireInside(child, container);
                check(child);
                if (child instanceof Container inner && !(child instanceof JComboBox<?>)) {
                    within(inner);
                }
            }
        }
    }

    private void check(Component child) {
        if (child instanceof AbstractButton button) {
            require(button, button.getText(), button.getPreferredSize().width, button.getPreferredSize().height);
        } else if (child instanceof JLabel label) {
            require(label, label.getText(), label.getPreferredSize().width, label.getPreferredSize().height);
        } else if (child instanceof JTextArea text) {
            require(text, text.getText(), 0, text.getPreferredSize().height);
        } else if (child instanceof JTextField field) {
            requireNumber(field);
        } else if (child instanceof JComboBox<?> combo) {
            chosen(combo);
        } else if (child instanceof JTabbedPane tabs) {
            titles(tabs);
        } else if (child instanceof JList<?> list) {
            cells(list);
        } else if (child instanceof JTable table) {
            cells(table);
        }
    }

    private void require(JComponent part, String text, int width, int height) {
        boolean isText = text != null && !text.isBlank();
        boolean isCut = part.getWidth() < width || part.getHeight() < height;
        boolean mayBeCut = isText && isOfUser(text) && text.equals(part.getToolTipText());
        if (isText && isCut && !mayBeCut) {
            found.add("\"" + text + "\" has " + part.getWidth() + " x " + part.getHeight() + " of " + width + " x "
                    + height);
        }
    }

    /** A component that scrolls may be larger than what shows it. */
    private void requireInside(Component child, Container container) {
        boolean isInside = new Rectangle(container.getSize()).contains(child.getBounds());
        if (container instanceof JViewport view) {
            boolean canScroll = view.getParent() instanceof JScrollPane scroll
                    && scroll.getHorizontalScrollBarPolicy() != ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER;
            isInside = canScroll || child.getWidth() <= view.getWidth();
        }
        if (!isInside && child.getWidth() > 0 && child.getHeight() > 0) {
            found.add(child.getClass().getSimpleName() + " " + child.getBounds() + " is outside of "
                    + container.getClass().getSimpleName() + " " + container.getSize());
        }
    }

    /** A longer text than its field scrolls; a number that does not show its last digits would be another one. */
    private void requireNumber(JTextField field) {
        Insets insets = field.getInsets();
        int room = field.getWidth() - insets.left - insets.right;
        int wanted = field.getFontMetrics(field.getFont()).stringWidth(field.getText());
        boolean isNumber = NUMBER.matcher(field.getText().strip()).matches();
        if (isNumber && wanted > room) {
            found.add("\"" + field.getText() + "\" has " + room + " of " + wanted);
        }
        Object hint = field.getClientProperty("JTextField.placeholderText");
        boolean isHintVisible = hint instanceof String && field.getText().isEmpty();
        int hintWidth = isHintVisible ? field.getFontMetrics(field.getFont()).stringWidth((String) hint) : 0;
        if (hintWidth > room) {
            found.add("\"" + hint + "\" has " + room + " of " + hintWidth);
        }
    }

    private <T> void chosen(JComboBox<T> combo) {
        T value = combo.getItemAt(Math.max(0, combo.getSelectedIndex()));
        if (value == null || combo.getSelectedItem() == null) {
            return;
        }
        ListCellRenderer<? super T> renderer = combo.getRenderer();
        Component cell = renderer.getListCellRendererComponent(new JList<T>(), value, -1, false, false);
        String text = cell instanceof JLabel label ? label.getText() : "";
        int arrow = combo.getHeight();
        if (cell.getPreferredSize().width + arrow > combo.getWidth() + arrow / 4 && !isOfUser(text)) {
            found.add("\"" + text + "\" has " + (combo.getWidth() - arrow) + " of " + cell.getPreferredSize().width);
        }
    }

    private void titles(JTabbedPane tabs) {
        for (int i = 0; i < tabs.getTabCount(); i++) {
            Rectangle place = tabs.getBoundsAt(i);
            if (place != null && place.x + place.width > tabs.getWidth()) {
                found.add("tab \"" + tabs.getTitleAt(i) + "\" ends at " + (place.x + place.width) + " of "
                        + tabs.getWidth());
            }
        }
    }

    private <T> void cells(JList<T> list) {
        for (int i = 0; i < list.getModel().getSize(); i++) {
            Component cell = list.getCellRenderer()
                    .getListCellRendererComponent(list, list.getModel().getElementAt(i), i, false, false);
            cell(cell, list.getCellBounds(i, i));
        }
    }

    private void cells(JTable table) {
        for (int row = 0; row < table.getRowCount(); row++) {
            for (int column = 0; column < table.getColumnCount(); column++) {
                Component cell = table.prepareRenderer(table.getCellRenderer(row, column), row, column);
                cell(cell, table.getCellRect(row, column, false));
            }
        }
        if (table.getTableHeader() != null) {
            for (int column = 0; column < table.getColumnCount(); column++) {
                Component cell = table.getTableHeader()
                        .getDefaultRenderer()
                        .getTableCellRendererComponent(table, table.getColumnName(column), false, false, -1, column);
                int height = cell.getPreferredSize().height;
                cell(
                        cell,
                        new Rectangle(table.getColumnModel().getColumn(column).getWidth(), height));
            }
        }
    }

    private void cell(Component cell, Rectangle place) {
        if (place == null) {
            return;
        }
        cell.setSize(place.getSize());
        cell.doLayout();
        if (cell instanceof JLabel label) {
            boolean mayBeCut = isOfUser(label.getText() == null ? "" : label.getText());
            if (!mayBeCut) {
                check(cell);
            }
        } else if (cell instanceof Container container) {
            within(container);
        }
    }
}
