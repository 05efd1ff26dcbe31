"""Links, joints, Assur groups, contours: a variant as a mechanism, and what its points say of velocities.

The words of the field.  *Link*: a rigid body (the frame is the fixed one).  *Driven point*: the point whose velocity is given.
*Mobility*: W = 3n - 2p5 - p4.  *Assur group*, *dyad*: two links that add no mobility.  *Assembly mode*: which of the two ways a
dyad closes.  *Dead point*: where a determinant is zero and the drive asks for what the links cannot give.  *Change point*: where
two motions meet.  *Residual*: by how much an equation is not satisfied; *drift*: its growth.  *Analog*: a derivative by the crank
angle.  *Step* h; *scheme*: how a step is made.
"""
