package nephele.engine.scene;

import nephele.engine.portal.Portal;

/**
 * A portal that a shot has taken away, while its rim closes.
 *
 * @param colour 0 or 1, the number of the shot
 * @param openness 1 when it begins, 0 when it has closed
 */
public record ClosingPortal(Portal portal, int colour, double openness) {}
