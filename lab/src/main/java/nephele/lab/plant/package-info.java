/** Makes the meshes of plants and rocks: a branching structure, tapered branches around it, leaves on it. */
package nephele.lab.plant;
