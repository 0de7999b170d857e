package nephele.editor.panel;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Arc2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.function.Consumer;
import javax.swing.Icon;

/**
 * A drawn icon of 16 units a side that grows with the size of the text.
 *
 * @param colour {@code null} for that of the component's text
 */
record PanelIcon(Consumer<Graphics2D> drawing, Color colour) implements Icon {
    static final Icon EYE = new PanelIcon(PanelIcon::eye, null);
    static final Icon EYE_SHUT = new PanelIcon(
            g -> {
                eye(g);
                g.draw(new Line2D.Double(2, 14, 14, 2));
            },
            null);
    static final Icon PADLOCK = new PanelIcon(
            g -> {
                g.fill(new RoundRectangle2D.Double(3, 7, 10, 7, 2, 2));
                g.draw(new Arc2D.Double(5, 2, 6, 9, 0, 180, Arc2D.OPEN));
            },
            null);
    static final Icon DOT = new PanelIcon(g -> g.fill(new Ellipse2D.Double(7, 7, 2, 2)), null);
    static final Icon FOLD_OPEN = new PanelIcon(g -> triangle(g, 4, 6, 12, 6, 8, 11), null);
    static final Icon FOLD_SHUT = new PanelIcon(g -> triangle(g, 6, 4, 11, 8, 6, 12), null);
    static final Icon MENU = new PanelIcon(
            g -> {
                for (int y : new int[] {3, 7, 11}) {
                    g.fill(new Ellipse2D.Double(7, y, 2, 2));
                }
            },
            null);
    static final Icon ERROR = new PanelIcon(
            g -> {
                g.fill(new Ellipse2D.Double(2, 2, 12, 12));
                g.setColor(Color.WHITE);
                g.draw(new Line2D.Double(5.5, 5.5, 10.5, 10.5));
                g.draw(new Line2D.Double(5.5, 10.5, 10.5, 5.5));
            },
            new Color(0xd04040));
    static final Icon WARNING = new PanelIcon(
            g -> {
                triangle(g, 8, 1, 15, 14, 1, 14);
                g.setColor(Color.BLACK);
                g.draw(new Line2D.Double(8, 6, 8, 9));
                g.fill(new Ellipse2D.Double(7.2, 11, 1.6, 1.6));
            },
            new Color(0xe0a020));
    static final Icon HINT = new PanelIcon(
            g -> {
                g.fill(new Ellipse2D.Double(2, 2, 12, 12));
                g.setColor(Color.WHITE);
                g.draw(new Line2D.Double(8, 7.5, 8, 11));
                g.fill(new Ellipse2D.Double(7.2, 4, 1.6, 1.6));
            },
            new Color(0x4080d0));

    /** Returns a square of a colour. */
    static Icon swatch(Color colour) {
        return new PanelIcon(
                g -> {
                    g.fill(new Rectangle2D.Double(1, 1, 14, 14));
                    g.setColor(Color.GRAY);
                    g.draw(new Rectangle2D.Double(1, 1, 14, 14));
                },
                colour);
    }

    private static void eye(Graphics2D g) {
        Path2D lid = new Path2D.Double();
        lid.moveTo(1, 8);
        lid.quadTo(8, 0, 15, 8);
        lid.quadTo(8, 16, 1, 8);
        g.draw(lid);
        g.fill(new Ellipse2D.Double(5.5, 5.5, 5, 5));
    }

    private static void triangle(Graphics2D g, double... xy) {
        Path2D path = new Path2D.Double();
        path.moveTo(xy[0], xy[1]);
        path.lineTo(xy[2], xy[3]);
        path.lineTo(xy[4], xy[5]);
        path.closePath();
        g.fill(path);
    }

    @Override
    public void paintIcon(Component component, Graphics graphics, int x, int y) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.translate(x, y);
        double scale = getIconWidth() / 16.0;
        g.scale(scale, scale);
        g.setStroke(new BasicStroke(1.4f));
        g.setColor(colour == null ? component.getForeground() : colour);
        drawing.accept(g);
        g.dispose();
    }

    @Override
    public int getIconWidth() {
        return UIScale.scale(16);
    }

    @Override
    public int getIconHeight() {
        return getIconWidth();
    }
}
