package nephele.editor.panel;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Insets;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.Optional;
import javax.swing.Icon;
import javax.swing.JToggleButton;
import javax.swing.SwingConstants;
import nephele.editor.widget.AssetPictures;
import nephele.engine.level.Material;

/** A button that shows a material: its picture times its colour, and its name. */
final class MaterialButton extends JToggleButton {
    private static final long serialVersionUID = 1;
    private static final int SIDE_POINTS = 48;

    MaterialButton(Material material, String name, AssetPictures pictures) {
        super(name, new Sample(material, pictures));
        setHorizontalTextPosition(SwingConstants.CENTER);
        setVerticalTextPosition(SwingConstants.BOTTOM);
        setIconTextGap(2);
        setMargin(new Insets(2, 0, 2, 0));
        setToolTipText(name);
        putClientProperty("JButton.buttonType", "toolBarButton");
        putClientProperty("FlatLaf.styleClass", "small");
    }

    private record Sample(Material material, AssetPictures pictures) implements Icon {
        @Override
        public void paintIcon(Component component, Graphics graphics, int x, int y) {
            Graphics2D g = (Graphics2D) graphics.create();
            g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
            int side = getIconWidth();
            Color colour = LinearColour.shown(material.baseColour());
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
            return UIScale.scale(SIDE_POINTS);
        }

        @Override
        public int getIconHeight() {
            return getIconWidth();
        }
    }
}
