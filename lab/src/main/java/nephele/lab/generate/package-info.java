/**
 * What {@code generate} makes: meshes of plants and rocks (a branching structure, tapered branches around it, leaves on it)
 * and height maps (noise shaped into ridges and valleys, then eroded by running water).
 */
package nephele.lab.generate;
